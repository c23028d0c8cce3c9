// SPDX-License-Identifier: MIT
// Noises of several methods and their exemplar -> pictures, measures and a page with both.
#include <lichen/base64.h>
#include <lichen/counted.h>
#include <lichen/escaped.h>
#include <lichen/image_io.h>
#include <lichen/map_picture.h>
#include <lichen/method_sheet.h>
#include <lichen/quality.h>
#include <lichen/synthesize.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

constexpr double kExemplars = 2.0; // of a picture, per side
constexpr double kBytesPerKib = 1024.0;

constexpr const char* kPageStart = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<style>
body { margin: 2rem; font: 16px/1.5 system-ui, sans-serif; }
table { border-collapse: collapse; margin: 1rem 0 2rem; }
th, td { padding: 0.25rem 1rem 0.25rem 0; border-bottom: 1px solid #8886; text-align: right; }
th:first-child { text-align: left; }
.looks { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; }
figcaption { font-weight: 600; }
</style>
)";

/// The text with the characters that mean something in HTML replaced.
std::string asText(const std::string& text) {
  std::string safe;
  for (const char c : escaped(text))
    switch (c) {
    case '&':
      safe += "&amp;";
      break;
    case '<':
      safe += "&lt;";
      break;
    case '>':
      safe += "&gt;";
      break;
    case '"':
      safe += "&quot;";
      break;
    default:
      safe += c;
    }
  return safe;
}

Result<std::string> figure(const std::string& caption, const SrgbImage& picture) {
  const Result<std::vector<std::byte>> png = encodePng(picture, 8);
  if (!png)
    return png.error();
  return fmt::format("<figure><figcaption>{}</figcaption><img alt=\"{}\" width=\"{}\" "
                     "src=\"data:image/png;base64,{}\"></figure>\n",
                     caption, caption, picture.width, encodeBase64(png.value()));
}

/// A line of the table: a name, and a cell for each method.
template <class Cell>
std::string tableLine(const std::string& name, const std::vector<MethodRow>& rows,
                      const Cell& cell) {
  std::string line = fmt::format("<tr><th scope=\"row\">{}</th>", name);
  for (const MethodRow& row : rows)
    line += fmt::format("<td>{}</td>", cell(row));
  return line + "</tr>\n";
}

std::string tableOf(const std::vector<MethodRow>& rows) {
  std::string table = "<table>\n";
  table += tableLine("", rows, [](const MethodRow& row) { return nameOf(row.method); });
  table += tableLine("look_distance", rows,
                     [](const MethodRow& row) { return fmt::format("{:.4f}", row.distance); });
  for (std::size_t m = 0; m < rows.front().measures.size(); ++m)
    table += tableLine(std::string(rows.front().measures[m].name), rows, [&](const MethodRow& row) {
      const Measure& measure = row.measures[m];
      return measure.value ? fmt::format("{:.3g} {}", *measure.value, measure.unit) : "-";
    });
  table += tableLine("memory on the GPU", rows, [](const MethodRow& row) {
    return fmt::format("{:.0f} KiB", double(row.gpuBytes) / kBytesPerKib);
  });
  table += tableLine("time of a pixel, in plain fetches", rows,
                     [](const MethodRow& row) { return fmt::format("{:.0f}", row.plainFetches); });
  table += tableLine("time of the bake", rows,
                     [](const MethodRow& row) { return fmt::format("{:.1f} s", row.bakeSeconds); });
  return table + "</table>\n";
}

Result<MethodSheet> sheetOf(const std::string& name, const MapExemplar& exemplar,
                            std::span<const MethodTrial> trials, const Progress& progress) {
  const SrgbImage shown = pictureOf(exemplar);
  MethodSheet sheet;
  Result<std::string> shownFigure = figure(asText(name), shown);
  if (!shownFigure)
    return shownFigure.error();
  std::string figures = std::move(shownFigure).value();
  for (std::size_t t = 0; t < trials.size(); ++t) {
    const MethodTrial& trial = trials[t];
    const double trialCount = double(trials.size());
    const Result<MethodLook> look =
        lookOf(trial, exemplar, kExemplars,
               partOf(progress, double(t) / trialCount, double(t + 1) / trialCount));
    if (!look)
      return look.error();
    Result<std::vector<Measure>> measures = measureResult(shown, look.value().picture);
    if (!measures)
      return measures.error();
    for (Measure& measure : measures.value())
      measure.target.reset();
    const Method method = trial.bundle.noises.front().method();
    sheet.rows.push_back({method, look.value().distance, std::move(measures).value(),
                          texelBytes(trial.bundle), trial.bakeSeconds, trial.plainFetches});
    const Result<std::string> picture = figure(std::string(nameOf(method)), look.value().picture);
    if (!picture)
      return picture.error();
    figures += picture.value();
  }
  const std::string title = asText(name) + " under " + counted(trials.size(), "method");
  const std::string page =
      kPageStart + fmt::format("<title>{}</title>\n</head>\n<body>\n<h1>{}</h1>\n", title, title) +
      tableOf(sheet.rows) + "<div class=\"looks\">\n" + figures + "</div>\n</body>\n</html>\n";
  const auto bytes = std::as_bytes(std::span(page));
  sheet.page.assign(bytes.begin(), bytes.end());
  return sheet;
}

} // namespace

SrgbImage pictureOf(const MapExemplar& exemplar) {
  return MapLook(exemplar, exemplar.encoding).picture(exemplar);
}

Result<MethodLook> lookOf(const MethodTrial& trial, const MapExemplar& exemplar, double exemplars,
                          const Progress& progress) {
  SynthesisOptions options;
  options.material = *trial.bundle.materials.front();
  options.map = exemplar.target;
  const auto side = [&](int pixels) {
    return std::min(kMethodLookSide, int(std::lround(exemplars * pixels)));
  };
  options.width = side(exemplar.width);
  options.height = side(exemplar.height);
  options.progress = progress;
  Result<LinearImage> result = synthesize(trial.bundle, options);
  if (!result)
    return result.error();
  return withinMemory([] { return "not enough memory to measure a noise"; },
                      [&]() -> Result<MethodLook> {
                        const MapLook look(exemplar, exemplar.encoding);
                        MethodLook made{look.picture(std::move(result).value()), 0.0};
                        const Result<double> distance =
                            lookDistance(look.picture(exemplar), made.picture);
                        if (!distance)
                          return distance.error();
                        made.distance = distance.value();
                        return made;
                      });
}

Result<MethodSheet> makeMethodSheet(const std::string& name, const MapExemplar& exemplar,
                                    std::span<const MethodTrial> trials, const Progress& progress) {
  return withinMemory([] { return "not enough memory for the sheet"; },
                      [&] { return sheetOf(name, exemplar, trials, progress); });
}

} // namespace lichen
