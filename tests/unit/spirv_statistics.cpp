// SPDX-License-Identifier: MIT
// The count of value operations that lichen-bench prints, on modules written out by hand.
#include <catch2/catch.hpp>

#include <cstdint>
#include <spirv_statistics.h>
#include <vector>

using lichen::bench::SpirvStatistics;
using lichen::bench::spirvStatistics;
using Words = std::vector<std::uint32_t>;

namespace {

enum Id : std::uint32_t { kFloat = 1, kVec3, kMat3, kVector, kMatrix, kFirstResult };

void append(Words& module, std::uint32_t opcode, const Words& operands) {
  module.push_back(std::uint32_t(operands.size() + 1) << 16 | opcode);
  module.insert(module.end(), operands.begin(), operands.end());
}

/// The types, a vector and a matrix, then a function with these instructions.
Words moduleOf(const std::vector<std::pair<std::uint32_t, Words>>& instructions) {
  Words module{0x07230203, 0x00010000, 0, 100, 0};
  append(module, 22, {kFloat, 32});       // OpTypeFloat
  append(module, 23, {kVec3, kFloat, 3}); // OpTypeVector
  append(module, 24, {kMat3, kVec3, 3});  // OpTypeMatrix
  append(module, 1, {kVec3, kVector});    // OpUndef
  append(module, 1, {kMat3, kMatrix});
  append(module, 54, {kFloat, kFirstResult, 0, 0}); // OpFunction
  for (const auto& [opcode, operands] : instructions)
    append(module, opcode, operands);
  append(module, 56, {}); // OpFunctionEnd
  return module;
}

int operationsOf(std::uint32_t opcode, const Words& operands) {
  return spirvStatistics(moduleOf({{opcode, operands}})).valueOperations;
}

} // namespace

TEST_CASE("an operation counts once per component of its result") {
  CHECK(operationsOf(129, {kVec3, 50, kVector, kVector}) == 3); // OpFAdd
  CHECK(operationsOf(127, {kVec3, 50, kVector}) == 3);          // OpFNegate
  CHECK(operationsOf(12, {kVec3, 50, 60, 13, kVector}) == 3);   // OpExtInst: Sin
  CHECK(operationsOf(207, {kFloat, 50, 51}) == 1);              // OpDPdx
}

TEST_CASE("a product of vectors or matrices counts its multiply-adds") {
  CHECK(operationsOf(148, {kFloat, 50, kVector, kVector}) == 3); // OpDot
  CHECK(operationsOf(145, {kVec3, 50, kMatrix, kVector}) == 9);  // OpMatrixTimesVector
  CHECK(operationsOf(144, {kVec3, 50, kVector, kMatrix}) == 9);  // OpVectorTimesMatrix
  CHECK(operationsOf(146, {kMat3, 50, kMatrix, kMatrix}) == 27); // OpMatrixTimesMatrix
}

TEST_CASE("what moves values is not a value operation, and a fetch counts as a fetch") {
  const SpirvStatistics statistics =
      spirvStatistics(moduleOf({{61, {kVec3, 50, 51}},       // OpLoad
                                {80, {kVec3, 52, kVector}},  // OpCompositeConstruct
                                {124, {kVec3, 53, kVector}}, // OpBitcast
                                {245, {kVec3, 54, 50, 55}},  // OpPhi
                                {88, {kVec3, 56, 57, kVector, 4, 50, 50}}})); // a sample
  CHECK(statistics.valueOperations == 0);
  CHECK(statistics.fetches == 1);
}

TEST_CASE("nothing counts outside functions or in broken SPIR-V") {
  Words module = moduleOf({});
  append(module, 129, {kVec3, 50, kVector, kVector});
  CHECK(spirvStatistics(module).valueOperations == 0);
  module = moduleOf({{129, {kVec3, 50, kVector, kVector}}});
  module[5] = 0; // an instruction of no words
  CHECK(spirvStatistics(module).valueOperations == 0);
  CHECK(spirvStatistics({}).valueOperations == 0);
}
