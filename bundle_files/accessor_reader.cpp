// SPDX-License-Identifier: MIT
// Accessors -> numbers; see accessor_reader.h. Input is hostile: the reader checks each count
// against the available bytes before it allocates memory.
#include "accessor_reader.h"

#include "object_reader.h"

#include <lichen/counted.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lichen {
namespace {

using nlohmann::json;

constexpr std::uint64_t kMostBytes = std::uint64_t(1) << 32;
/// Maximum number of elements of an accessor without a buffer view, whose elements are zero: 48 MiB
/// of vectors that no byte of the file backs.
constexpr std::size_t kMostZeros = std::size_t(1) << 22;

std::size_t componentBytes(std::uint64_t type) {
  switch (type) {
  case kByte:
  case kUnsignedByte:
    return 1;
  case kShort:
  case kUnsignedShort:
    return 2;
  case kUnsignedInt:
  case kFloat:
    return 4;
  default:
    return 0;
  }
}

template <class Number>
Number load(const std::byte* bytes) {
  Number value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

template <class Integer>
float asFloat(const std::byte* bytes, bool isNormalized) {
  const auto value = float(load<Integer>(bytes));
  return isNormalized ? std::max(value / float(std::numeric_limits<Integer>::max()), -1.0f) : value;
}

float loadFloat(const std::byte* bytes, std::uint64_t type, bool isNormalized) {
  switch (type) {
  case kByte:
    return asFloat<std::int8_t>(bytes, isNormalized);
  case kUnsignedByte:
    return asFloat<std::uint8_t>(bytes, isNormalized);
  case kShort:
    return asFloat<std::int16_t>(bytes, isNormalized);
  case kUnsignedShort:
    return asFloat<std::uint16_t>(bytes, isNormalized);
  case kUnsignedInt:
    return asFloat<std::uint32_t>(bytes, isNormalized);
  default:
    return load<float>(bytes);
  }
}

std::uint32_t loadIndex(const std::byte* bytes, std::uint64_t type) {
  return type == kUnsignedByte    ? load<std::uint8_t>(bytes)
         : type == kUnsignedShort ? load<std::uint16_t>(bytes)
                                  : load<std::uint32_t>(bytes);
}

/// Elements of equal size, one every `stride` bytes, within bounds.
struct Elements {
  const std::byte* first = nullptr;
  std::size_t stride = 0;

  [[nodiscard]] const std::byte* at(std::size_t i) const { return first + i * stride; }
};

/// Thrown to stop reading an accessor after its fault is recorded.
struct Unreadable {};

class AccessorReader {
public:
  AccessorReader(GltfFile& file, std::size_t index, FindingList& findings)
      : file_(file), findings_(findings), pointer_("/accessors/" + std::to_string(index)),
        json_(elementOf(index)), reader_(json_, pointer_, findings) {}

  /// Reads the accessor's description. `types` lists the valid component types.
  void describe(const char* type, std::size_t components,
                std::initializer_list<std::uint64_t> types) {
    count_ = std::size_t(integer(reader_, "count", kMostElements));
    componentType_ = componentType(reader_, types);
    elementBytes_ = components * componentBytes(componentType_);
    const auto name = reader_.text("type");
    if (name && *name != type)
      reader_.error(kAccessorType, "type", quoted(*name) + "; expected " + type);
    if (!name || *name != type)
      throw Unreadable{};
    if (count_ == 0)
      fail("count", "0; expected at least 1");
    if (const json* normalized = reader_.optional("normalized"); normalized != nullptr) {
      if (!normalized->is_boolean())
        fail("normalized", "not true or false");
      isNormalized_ = normalized->get<bool>();
    }
  }

  /// Returns `convert(bytes of an element)` for all elements. Sparse elements replace dense ones;
  /// elements without a buffer view are zero. Allocates only after it has found the bytes.
  template <class Convert>
  auto values(const Convert& convert) {
    const std::optional<Elements> dense =
        reader_.has("bufferView") ? std::optional(elementsOf(reader_, count_, elementBytes_, true))
                                  : std::nullopt;
    const std::optional<SparseElements> sparse = sparseElements();
    if (!dense && count_ > kMostZeros)
      fail("count", std::to_string(count_) + " without a bufferView; expected 1 to " +
                        std::to_string(kMostZeros));
    std::vector<decltype(convert(nullptr))> list(count_);
    for (std::size_t i = 0; dense && i < count_; ++i)
      list[i] = convert(dense->at(i));
    for (std::size_t i = 0; sparse && i < sparse->count; ++i) {
      const std::uint32_t element = loadIndex(sparse->indices.at(i), sparse->indexType);
      if (element >= count_)
        fail("sparse/indices",
             std::to_string(element) + "; expected an index below " + std::to_string(count_));
      list[element] = convert(sparse->values.at(i));
    }
    return list;
  }

  [[nodiscard]] std::uint64_t type() const { return componentType_; }
  [[nodiscard]] bool isNormalized() const { return isNormalized_; }

  [[noreturn]] void fail(const char* key, const std::string& what) {
    findings_.error("accessor", pointer_ + (*key == 0 ? "" : "/") + key, what);
    throw Unreadable{};
  }

private:
  struct SparseElements {
    std::size_t count = 0;
    Elements indices;
    std::uint64_t indexType = 0;
    Elements values;
  };

  std::optional<SparseElements> sparseElements() {
    const json* member = reader_.optional("sparse");
    if (member == nullptr)
      return std::nullopt;
    ObjectReader place(*member, pointer_ + "/sparse", findings_);
    SparseElements sparse;
    sparse.count = std::size_t(integer(place, "count", count_));
    ObjectReader indices = inside(place, "indices"), replaced = inside(place, "values");
    sparse.indexType = componentType(indices, {kUnsignedByte, kUnsignedShort, kUnsignedInt});
    if (sparse.count == 0)
      fail("sparse/count", "0; expected at least 1");
    sparse.indices = elementsOf(indices, sparse.count, componentBytes(sparse.indexType), false);
    sparse.values = elementsOf(replaced, sparse.count, elementBytes_, false);
    return sparse;
  }

  [[nodiscard]] const json& elementOf(std::size_t index) {
    const auto list = file_.document().find("accessors");
    if (list == file_.document().end() || !list->is_array() || index >= list->size()) {
      findings_.error("accessor", pointer_, "absent");
      throw Unreadable{};
    }
    return (*list)[index];
  }

  std::uint64_t integer(ObjectReader& reader, const char* key, std::uint64_t most) {
    const auto value = reader.integer(key, most);
    if (!value)
      throw Unreadable{};
    return *value;
  }

  std::uint64_t componentType(ObjectReader& reader, std::initializer_list<std::uint64_t> valid) {
    const std::uint64_t type = integer(reader, "componentType", kFloat);
    if (std::find(valid.begin(), valid.end(), type) == valid.end()) {
      std::string list;
      for (const std::uint64_t each : valid)
        list += (list.empty() ? "" : ", ") + std::to_string(each);
      reader.error(kAccessorType, "componentType",
                   std::to_string(type) + "; expected one of " + list);
      throw Unreadable{};
    }
    return type;
  }

  ObjectReader inside(ObjectReader& reader, const char* key) {
    const json* value = reader.required(key);
    if (value == nullptr || !value->is_object()) {
      findings_.error("accessor", reader.pointerTo(key), "absent or not an object");
      throw Unreadable{};
    }
    return {*value, reader.pointerTo(key), findings_};
  }

  /// Finds `count` > 0 elements of `size` bytes in the buffer view that an object names.
  Elements elementsOf(ObjectReader& reader, std::size_t count, std::size_t size, bool mayStride) {
    const auto views = file_.document().find("bufferViews");
    const bool hasViews = views != file_.document().end() && views->is_array() && !views->empty();
    const auto view = std::size_t(integer(reader, "bufferView", hasViews ? views->size() - 1 : 0));
    const auto offset = reader.has("byteOffset")
                            ? std::size_t(integer(reader, "byteOffset", kMostBytes))
                            : std::size_t(0);
    refuseCompressed(view);
    const auto bytes = file_.stridedView(view, findings_);
    if (!bytes)
      throw Unreadable{};
    const std::size_t stride = mayStride && bytes->stride != 0 ? bytes->stride : size;
    const std::size_t there = bytes->bytes.size();
    if (stride < size || offset > there || there - offset < size ||
        (there - offset - size) / stride < count - 1) {
      findings_.error("accessor", reader.pointer(),
                      counted(count, "element") + " of " + counted(size, "byte") + ", one every " +
                          std::to_string(stride) + " from " + std::to_string(offset) +
                          " on; the view has " + std::to_string(there));
      throw Unreadable{};
    }
    return {bytes->bytes.data() + offset, stride};
  }

  void refuseCompressed(std::size_t view) {
    const std::optional<std::string> name = file_.compressionOf(view);
    if (!name)
      return;
    findings_.error("compressed", "/bufferViews/" + std::to_string(view),
                    "is compressed with " + *name + "; export the vertices without compression");
    throw Unreadable{};
  }

  GltfFile& file_;
  FindingList& findings_;
  std::string pointer_;
  const json& json_;
  ObjectReader reader_;
  std::size_t count_ = 0;
  std::uint64_t componentType_ = 0;
  std::size_t elementBytes_ = 0;
  bool isNormalized_ = false;
};

} // namespace

template <std::size_t kComponents>
std::optional<std::vector<std::array<float, kComponents>>>
readVectors(GltfFile& file, std::size_t accessor, FindingList& findings,
            std::initializer_list<std::uint64_t> types) {
  try {
    AccessorReader reader(file, accessor, findings);
    constexpr std::size_t kMatrix = 16;
    const std::string type = kComponents == kMatrix ? "MAT4" : "VEC" + std::to_string(kComponents);
    reader.describe(type.c_str(), kComponents, types);
    const std::size_t bytes = componentBytes(reader.type());
    return reader.values([&](const std::byte* element) {
      std::array<float, kComponents> value{};
      for (std::size_t c = 0; c < kComponents; ++c) {
        value[c] = loadFloat(element + c * bytes, reader.type(), reader.isNormalized());
        if (!std::isfinite(value[c]))
          reader.fail("", "contains NaN or infinity; all values must be finite");
      }
      return value;
    });
  } catch (const Unreadable&) {
    return std::nullopt;
  }
}

// clang-format off
template std::optional<std::vector<std::array<float, 2>>>
readVectors<2>(GltfFile&, std::size_t, FindingList&, std::initializer_list<std::uint64_t>);
template std::optional<std::vector<std::array<float, 3>>>
readVectors<3>(GltfFile&, std::size_t, FindingList&, std::initializer_list<std::uint64_t>);
template std::optional<std::vector<std::array<float, 4>>>
readVectors<4>(GltfFile&, std::size_t, FindingList&, std::initializer_list<std::uint64_t>);
template std::optional<std::vector<std::array<float, 16>>>
readVectors<16>(GltfFile&, std::size_t, FindingList&, std::initializer_list<std::uint64_t>);
// clang-format on

std::optional<std::vector<std::uint32_t>> readIndices(GltfFile& file, std::size_t accessor,
                                                      std::size_t limit, FindingList& findings) {
  try {
    AccessorReader reader(file, accessor, findings);
    reader.describe("SCALAR", 1, {kUnsignedByte, kUnsignedShort, kUnsignedInt});
    return reader.values([&](const std::byte* element) {
      const std::uint32_t value = loadIndex(element, reader.type());
      if (value >= limit)
        reader.fail("bufferView", "index " + std::to_string(value) + "; expected an index below " +
                                      std::to_string(limit));
      return value;
    });
  } catch (const Unreadable&) {
    return std::nullopt;
  }
}

std::vector<std::uint32_t> asTriangleList(std::vector<std::uint32_t> indices, std::uint64_t mode) {
  if (mode == kTriangles) {
    indices.resize(indices.size() - indices.size() % 3);
    return indices;
  }
  std::vector<std::uint32_t> list;
  for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
    if (mode == kTriangleFan)
      list.insert(list.end(), {indices[i + 1], indices[i + 2], indices[0]});
    else
      list.insert(list.end(), {indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]});
  }
  return list;
}

} // namespace lichen
