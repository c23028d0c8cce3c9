// SPDX-License-Identifier: MIT
#include "spirv_statistics.h"

#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace lichen::bench {
namespace {

constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::size_t kHeaderWords = 5;

/// SPIR-V specification 1.6, section 3.49.
enum Opcode : std::uint32_t {
  kExtInst = 12,
  kFirstType = 19, // OpTypeVoid
  kTypeVector = 23,
  kTypeMatrix = 24,
  kLastType = 39, // OpTypeForwardPointer
  kFunction = 54,
  kFunctionEnd = 56,
  kFirstSample = 87, // OpImageSampleImplicitLod
  kLastSample = 97,  // OpImageDrefGather
  kImageQueryLod = 105,
  kFirstConversion = 109, // OpConvertFToU
  kLastConversion = 116,  // OpQuantizeToF16
  kFirstArithmetic = 126, // OpSNegate
  kVectorTimesMatrix = 144,
  kMatrixTimesVector = 145,
  kMatrixTimesMatrix = 146,
  kDot = 148,
  kLastArithmetic = 152,  // OpSMulExtended
  kFirstLogical = 154,    // OpAny
  kLastLogical = 191,     // OpFUnordGreaterThanEqual
  kFirstBit = 194,        // OpShiftRightLogical
  kLastBit = 205,         // OpBitCount
  kFirstDerivative = 207, // OpDPdx
  kLastDerivative = 215,  // OpFwidthCoarse
};

bool isBetween(std::uint32_t value, std::uint32_t first, std::uint32_t last) {
  return first <= value && value <= last;
}

bool isValueOperation(std::uint32_t opcode) {
  return opcode == kExtInst || opcode == kImageQueryLod ||
         isBetween(opcode, kFirstConversion, kLastConversion) ||
         isBetween(opcode, kFirstArithmetic, kLastArithmetic) ||
         isBetween(opcode, kFirstLogical, kLastLogical) || isBetween(opcode, kFirstBit, kLastBit) ||
         isBetween(opcode, kFirstDerivative, kLastDerivative);
}

/// The numbers of components of all types and values.
class Components {
public:
  /// Reads what an instruction declares. Where its first operand is a type, the second is the
  /// result.
  void read(std::uint32_t opcode, std::span<const std::uint32_t> operands) {
    if (isBetween(opcode, kFirstType, kLastType) && !operands.empty()) {
      const bool hasParts = (opcode == kTypeVector || opcode == kTypeMatrix) && operands.size() > 2;
      types_[operands[0]] = hasParts ? ofType(operands[1]) * int(operands[2]) : 1;
    } else if (operands.size() > 1 && types_.contains(operands[0])) {
      values_[operands[1]] = ofType(operands[0]);
    }
  }
  [[nodiscard]] int ofType(std::uint32_t id) const { return find(types_, id); }
  [[nodiscard]] int ofValue(std::uint32_t id) const { return find(values_, id); }

private:
  using Counts = std::unordered_map<std::uint32_t, int>;
  static int find(const Counts& counts, std::uint32_t id) {
    const auto found = counts.find(id);
    return found == counts.end() ? 1 : found->second;
  }
  Counts types_, values_;
};

/// `operands` are the type, the result and what the operation reads.
int scalarOperations(std::uint32_t opcode, std::span<const std::uint32_t> operands,
                     const Components& components) {
  const int result = components.ofType(operands[0]);
  if (operands.size() < 4)
    return result;
  const int left = components.ofValue(operands[2]), right = components.ofValue(operands[3]);
  switch (opcode) {
  case kDot:
  case kMatrixTimesVector:
    return left;
  case kVectorTimesMatrix:
    return right;
  case kMatrixTimesMatrix: // (a x b) (b x c): a b c multiply-adds
    return int(std::lround(std::sqrt(double(left) * double(right) * double(result))));
  default:
    return result;
  }
}

} // namespace

SpirvStatistics spirvStatistics(std::span<const std::uint32_t> module) {
  SpirvStatistics statistics;
  if (module.size() < kHeaderWords || module[0] != kMagic)
    return statistics;
  Components components;
  bool isInFunction = false;
  for (std::size_t word = kHeaderWords; word < module.size();) {
    const std::uint32_t opcode = module[word] & 0xFFFF;
    const std::size_t words = module[word] >> 16;
    if (words == 0 || words > module.size() - word)
      return {};
    const std::span<const std::uint32_t> operands = module.subspan(word + 1, words - 1);
    word += words;
    components.read(opcode, operands);
    isInFunction = (isInFunction || opcode == kFunction) && opcode != kFunctionEnd;
    if (!isInFunction || operands.size() < 2)
      continue;
    if (isBetween(opcode, kFirstSample, kLastSample))
      ++statistics.fetches;
    else if (isValueOperation(opcode))
      statistics.valueOperations += scalarOperations(opcode, operands, components);
  }
  return statistics;
}

} // namespace lichen::bench
