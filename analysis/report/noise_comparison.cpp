// SPDX-License-Identifier: MIT
// Bundle and exemplar -> pictures of both and the measures between them.
#include "exemplar/resample.h"
#include "method_report.h"

#include <lichen/layered_noise.h>
#include <lichen/noise_comparison.h>
#include <lichen/noise_verdict.h>

#include <algorithm>

namespace lichen {
namespace {

constexpr int kResultExemplars = 4; // per side
constexpr int kGlanceExemplars = 2; // per side of a small result
constexpr int kLargestGlanceSide = 1024;

std::string listOf(const std::vector<MapChannel>& channels) {
  std::string list;
  for (const MapChannel channel : channels)
    list += (list.empty() ? "" : ", ") + std::string(nameOf(channel));
  return list;
}

/// The noise's map with the exemplar's target.
Result<const NoiseMap*> mapOf(const Bundle& bundle, std::size_t noise,
                              const MapExemplar& exemplar) {
  if (noise >= bundle.noises.size())
    return Error{ErrorKind::usage, "noise " + std::to_string(noise) + ": the bundle has " +
                                       std::to_string(bundle.noises.size())};
  const std::optional<std::size_t> place = findMap(bundle.noises[noise], exemplar.target);
  if (!place)
    return Error{ErrorKind::usage, "noise '" + bundle.noises[noise].name + "' has no map " +
                                       std::string(nameOf(exemplar.target))};
  const NoiseMap& map = bundle.noises[noise].maps[*place];
  if (map.channels != exemplar.channels)
    return Error{ErrorKind::badInput, "the map " + std::string(nameOf(map.target)) + " of noise '" +
                                          bundle.noises[noise].name + "' has the channels " +
                                          listOf(map.channels) + "; the exemplar has " +
                                          listOf(exemplar.channels)};
  return &map;
}

/// A result of a noise, of `exemplars` per side, and its exemplar, with measures of both.
class Comparison {
public:
  Comparison(const Bundle& bundle, const MaterialNoise& material, const NoiseMap& map,
             const MapExemplar& given)
      : bundle_(bundle), map_(map), method_(reportOf(bundle.noises[material.noise].method())),
        given_(given) {
    const auto [width, height] = exemplarSize(bundle, bundle.noises[material.noise], map);
    width_ = int(width);
    height_ = int(height);
    if (method_.enlargesMaps && (given.width != width_ || given.height != height_))
      enlarged_ = exemplar::resampled(given, width_, height_, false);
    options_.material = material;
    options_.map = map.target;
    if (material.mix.source == MixSource::constant)
      options_.mix = {material.mix.weight, material.mix.weight};
  }

  /// Compares on a result of kResultExemplars per side, with all measures.
  [[nodiscard]] Result<NoiseComparison> whole(const Progress& progress) {
    options_.width = std::min(kResultExemplars * width_, kLargestResultSide);
    options_.height = std::min(kResultExemplars * height_, kLargestResultSide);
    const double share = 1.0 - method_.judgedShare;
    Result<NoiseComparison> comparison = measured(partOf(progress, 0.0, share));
    if (!comparison || !method_.judge)
      return comparison;
    if (Result<void> judged =
            method_.judge(compared(partOf(progress, share, 1.0)), comparison.value());
        !judged)
      return judged.error();
    return comparison;
  }

  [[nodiscard]] Result<NoiseComparison> small(const Progress& progress) {
    const auto side = [](int exemplar) {
      return std::min(kGlanceExemplars * exemplar, std::max(exemplar, kLargestGlanceSide));
    };
    options_.width = std::min(side(width_), kLargestResultSide);
    options_.height = std::min(side(height_), kLargestResultSide);
    return measured(progress);
  }

private:
  [[nodiscard]] const MapExemplar& exemplar() const { return enlarged_ ? *enlarged_ : given_; }
  [[nodiscard]] ComparedResult compared(const Progress& progress) const {
    return {bundle_, map_, exemplar(), enlarged_.has_value(), options_, progress};
  }
  [[nodiscard]] Result<NoiseComparison> measured(const Progress& progress) {
    options_.progress = progress;
    const Result<LinearImage> result = synthesize(bundle_, options_);
    if (!result)
      return result.error();
    const MapLook look(exemplar(), map_.encoding);
    NoiseComparison comparison{
        look, look.picture(exemplar()), look.picture(result.value()), {}, {}};
    if (Result<void> taken = method_.measure(compared({}), comparison); !taken)
      return taken.error();
    return comparison;
  }

  const Bundle& bundle_;
  const NoiseMap& map_;
  const MethodReport& method_;
  const MapExemplar& given_;
  std::optional<MapExemplar> enlarged_;
  int width_ = 0, height_ = 0; ///< of the map's exemplar
  SynthesisOptions options_;
};

/// Calls compare(comparison) for the exemplar's map.
template <class Compare>
Result<NoiseComparison> compared(const Bundle& bundle, const MaterialNoise& material,
                                 const MapExemplar& exemplar, const Compare& compare) {
  return withinMemory([] { return "not enough memory to compare the noise with its exemplar"; },
                      [&]() -> Result<NoiseComparison> {
                        const Result<const NoiseMap*> map = mapOf(bundle, material.noise, exemplar);
                        if (!map)
                          return map.error();
                        Comparison comparison(bundle, material, *map.value(), exemplar);
                        return compare(comparison);
                      });
}

/// Removes the methods that layers do not take from what helps against the risks of a layered
/// noise.
void keepLayerable(std::vector<Risk>& risks) {
  const auto isRefused = [](const BakeSetting& setting) {
    const std::optional<Method> method =
        setting.name == "method" ? methodFrom(setting.value) : std::nullopt;
    return method && !isLayerable(*method);
  };
  for (Risk& risk : risks)
    std::erase_if(risk.settings, isRefused);
}

} // namespace

Result<NoiseComparison> compareNoise(const Bundle& bundle, const MaterialNoise& material,
                                     const MapExemplar& exemplar, const Progress& progress) {
  return compared(bundle, material, exemplar,
                  [&](Comparison& comparison) { return comparison.whole(progress); });
}

Result<std::vector<Measure>> measureNoise(const Bundle& bundle, const MaterialNoise& material,
                                          const MapExemplar& exemplar, const Progress& progress) {
  Result<NoiseComparison> small = compared(bundle, material, exemplar, [&](Comparison& comparison) {
    return comparison.small(progress);
  });
  if (!small)
    return small.error();
  return std::move(small.value().measures);
}

Result<std::vector<std::vector<Risk>>> assessNoise(const Noise& noise,
                                                   std::span<const MapExemplar> maps,
                                                   Periodic borders, const Progress& progress) {
  return withinMemory([] { return "not enough memory to assess the exemplar"; },
                      [&]() -> Result<std::vector<std::vector<Risk>>> {
                        AssessedMap assessed{noise, maps, 0, bordersFit(maps, borders)};
                        std::vector<std::vector<Risk>> all;
                        const auto count = double(maps.size());
                        for (; assessed.place < maps.size(); ++assessed.place) {
                          const Progress part = partOf(progress, double(assessed.place) / count,
                                                       double(assessed.place + 1) / count);
                          Result<std::vector<Risk>> risks =
                              reportOf(noise.method()).assess(assessed, part);
                          if (!risks)
                            return risks.error();
                          if (noise.layers)
                            keepLayerable(risks.value());
                          all.push_back(std::move(risks).value());
                        }
                        return all;
                      });
}

bool enlargesMaps(Method method) { return reportOf(method).enlargesMaps; }

} // namespace lichen
