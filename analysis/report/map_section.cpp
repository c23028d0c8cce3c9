// SPDX-License-Identifier: MIT
// Map of a bundle and its exemplar -> the map's section of the report.
#include "map_section.h"

#include "charts.h"
#include "markup.h"
#include "pictures.h"

#include <lichen/noise_comparison.h>
#include <lichen/synthesize.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen {
namespace {

constexpr int kShownExemplars = 2; // of the result, per side
constexpr std::string_view kKeys =
    R"(<i class="key exemplar"></i> exemplar <i class="key result"></i> result)";

std::string summaryOf(const MapExemplar& exemplar) {
  std::string text;
  for (const MapChannel channel : exemplar.channels)
    text += (text.empty() ? "" : ", ") + std::string(nameOf(channel));
  return text + "; " + std::string(nameOf(exemplar.encoding)) + "; " +
         std::to_string(exemplar.width) + " x " + std::to_string(exemplar.height) + " pixels";
}

/// The size of the result's picture at the same scale: kShownExemplars per side, or, for narrow
/// exemplars, enough to make it half as wide as long.
Extents resultExtents(const Extents& exemplar, int side) {
  Extents extents{kShownExemplars * exemplar[0], kShownExemplars * exemplar[1]};
  const std::size_t longer = extents[0] < extents[1] ? 1 : 0;
  int& length = extents[longer];
  int& breadth = extents[1 - longer];
  if (length > 2 * breadth) {
    length = std::min(length, int(std::sqrt(2.0) * kShownExemplars * side)); // as many pixels
    breadth = std::max(breadth, length / 2);
  }
  return extents;
}

/// Pictures of the original, the exemplar, the exemplar repeated, its Gaussian version and the
/// result, at one scale unless the original is too large for it. The original is left out if the
/// exemplar is unchanged.
Result<std::string> panesOf(const Bundle& bundle, const MaterialNoise& material,
                            const ShownExemplar& shown, const NoiseComparison& comparison,
                            int exemplarSide) {
  const auto [width, height] =
      pictureExtents(shown.exemplar.width, shown.exemplar.height, exemplarSide);
  SynthesisOptions options;
  options.material = material;
  options.map = shown.exemplar.target;
  options.texelsPerTile = width;
  const Extents extents = resultExtents({width, height}, exemplarSide);
  options.width = extents[0];
  options.height = extents[1];
  const Result<LinearImage> result = synthesize(bundle, options);
  if (!result)
    return result.error();
  std::vector<Result<Picture>> made;
  if (const std::optional<MapExemplar>& before = shown.origin.original; before) {
    const auto [across, down] = pictureExtents(before->width, before->height, exemplarSide);
    made.push_back(encodedPicture(reduced(comparison.look.picture(*before), across, down),
                                  "Original", ", before it was flattened, filled or straightened"));
  }
  std::string steps;
  for (const std::string& step : shown.origin.steps)
    steps += ", " + step;
  made.push_back(encodedPicture(reduced(comparison.exemplar, width, height), "Exemplar", steps));
  const std::size_t exemplar = made.size() - 1;
  if (const std::optional<SrgbImage>& texture = comparison.gaussian; texture)
    made.push_back(
        encodedPicture(reduced(*texture, width * texture->width / comparison.exemplar.width,
                               height * texture->height / comparison.exemplar.height),
                       "Gaussian version", " of the exemplar: as near as random phases can come"));
  made.push_back(
      encodedPicture(comparison.look.picture(result.value()), "Result", " of the noise"));
  const Result<std::vector<Picture>> pictures = allOf(std::move(made));
  if (!pictures)
    return pictures.error();
  double allWidths = extents[0]; // the repeated exemplar is as wide as the result
  for (const Picture& picture : pictures.value())
    allWidths += picture.extents[0];
  const auto widthsOf = [&](int pixels) {
    return ShownWidths{pixels / allWidths, double(pixels) / extents[0]};
  };
  std::string panes;
  for (std::size_t i = 0; i < pictures.value().size(); ++i) {
    const Picture& picture = pictures.value()[i];
    panes += paneMarkup(imageMarkup(picture, widthsOf(picture.extents[0])),
                        element("b", picture.title) + htmlText(picture.text));
    if (i == exemplar)
      panes += paneMarkup(repeatedMarkup(picture, extents, widthsOf(extents[0])),
                          "<b>Repeated</b> as a plain texture");
  }
  return element("div class=\"panes\"", panes);
}

std::string rowOf(const Measure& measure) {
  const auto number = [&](const std::optional<double>& value) {
    return element("td class=\"number\"", value ? shownNumber(*value, measure.unit) : "");
  };
  const std::string remark = measure.remark.empty() ? "" : "; " + measure.remark;
  const std::string verdict = !measure.value       ? element("td", "not measured")
                              : !measure.target    ? element("td", "no target")
                              : measure.isMissed() ? element("td class=\"bad\"", "\u2717 missed")
                                                   : element("td class=\"good\"", "\u2713 met");
  return element("tr", element("th scope=\"row\"",
                               std::string(measure.name) +
                                   element("span class=\"detail\"",
                                           htmlText(std::string(measure.meaning) + remark))) +
                           number(measure.value) + number(measure.target) + verdict) +
         "\n";
}

std::string measuresOf(const NoiseComparison& comparison) {
  std::string rows =
      R"(<tr class="quiet"><th scope="col">Measure</th><th scope="col" class="number">)"
      R"(Value</th><th scope="col" class="number">Target</th>)"
      R"(<th scope="col">Verdict</th></tr>)"
      "\n";
  for (const Measure& measure : comparison.measures)
    rows += rowOf(measure);
  return "<h3>Measures</h3>\n" + element("table", rows);
}

std::string risksOf(const ShownExemplar& shown, SettingWords words) {
  constexpr std::array<std::string_view, 3> kLooks{"good", "warn", "bad"};
  std::string items;
  for (const Risk& risk : shown.risks) {
    const std::string remedy = remedyOf(risk, words);
    items += element(
        "li",
        element("b", risk.name) + " " +
            element(fmt::format("span class=\"{}\"", kLooks[std::size_t(risk.level)]),
                    fmt::format("{}, {:.2f} of 1", nameOf(risk.level), risk.score)) +
            element("span class=\"detail\"", htmlText(risk.sentence)) +
            (remedy.empty() ? ""
                            : element("span class=\"detail\"", htmlText("What helps: " + remedy))));
  }
  return items.empty() ? ""
                       : "<h3>Risks of this exemplar</h3>\n" + element("ul class=\"risks\"", items);
}

std::string histogramsOf(const NoiseComparison& comparison) {
  std::string charts;
  const std::vector<std::string>& names = comparison.look.channelNames();
  for (std::size_t c = 0; c < names.size(); ++c)
    charts += element("figure", element("figcaption", names[c]) +
                                    histogramChart(comparison.exemplar, comparison.result, c,
                                                   comparison.look.largest()));
  return "<h3>Histograms</h3>\n" + element("p class=\"quiet\"", kKeys) +
         element("div class=\"histograms\"", charts);
}

/// Empty if the exemplar is too small for spectrum_distance_db.
std::string spectrumOf(const NoiseComparison& comparison) {
  const int crop = spectrumCrop(comparison.exemplar, comparison.result);
  if (crop == 0)
    return {};
  std::vector<SpectrumCurve> curves{spectrumCurve("exemplar", comparison.exemplar, crop)};
  if (comparison.gaussian)
    curves.push_back(spectrumCurve("gaussian", *comparison.gaussian, crop));
  curves.push_back(spectrumCurve("result", comparison.result, crop));
  return "<h3>Power spectrum</h3>\n" +
         element(
             "p class=\"quiet\"",
             std::string(kKeys) +
                 (comparison.gaussian ? R"( <i class="key gaussian"></i> Gaussian version)" : "") +
                 "; of the luminance, averaged over directions") +
         spectrumChart(curves, crop);
}

} // namespace

Result<MapSection> describeMap(const Bundle& bundle, const MaterialNoise& material,
                               const ShownExemplar& shown, SettingWords words, int exemplarSide,
                               const Progress& progress) {
  const MapExemplar& exemplar = shown.exemplar;
  Result<NoiseComparison> compared = compareNoise(bundle, material, exemplar, progress);
  if (!compared)
    return compared.error();
  NoiseComparison& comparison = compared.value();
  const Result<std::string> panes = panesOf(bundle, material, shown, comparison, exemplarSide);
  if (!panes)
    return panes.error();
  std::string markup =
      element("article", element("h2", nameOf(exemplar.target)) +
                             element("p class=\"quiet\"", summaryOf(exemplar)) + panes.value() +
                             measuresOf(comparison) + risksOf(shown, words) +
                             histogramsOf(comparison) + spectrumOf(comparison)) +
      "\n";
  return MapSection{shown, std::move(markup), std::move(comparison.measures)};
}

} // namespace lichen
