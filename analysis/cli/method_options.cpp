// SPDX-License-Identifier: MIT
// Options of each method -> its bake.
#include "method_options.h"

namespace lichen::cli {
namespace {

constexpr const char* kTilingGroup = "Tiling";
constexpr const char* kTextonGroup = "Texton";

const char* groupOf(Method method) {
  return method == Method::tiling ? kTilingGroup : kTextonGroup;
}

void addTilingOptions(CLI::App& verb, TilingOptions& tiling) {
  const Choices<TransportEffort> efforts{{"fast", TransportEffort::fast},
                                         {"default", TransportEffort::standard},
                                         {"exact", TransportEffort::exact}};
  addValue(verb, "--transport", tiling.transport, oneOf(efforts), "default",
           "How near to optimal colours are matched")
      .group(kTilingGroup);
  const Choices<LookupTable> luts{{"joint", LookupTable::joint},
                                  {"separable", LookupTable::separable}};
  addValue(verb, "--lut", tiling.lut, oneOf(luts), "joint",
           "One table of all colours, or a small one for each axis of colour")
      .group(kTilingGroup);
  const Choices<GaussianOnly> gaussian{
      {"auto", GaussianOnly::detect}, {"yes", GaussianOnly::yes}, {"no", GaussianOnly::no}};
  addValue(verb, "--gaussian", tiling.gaussian, oneOf(gaussian), "auto",
           "Whether the exemplar's values are Gaussian, and need no table")
      .group(kTilingGroup);
}

void addTextonOptions(CLI::App& verb, TextonOptions& texton, MaterialNoise& material) {
  addValue(verb, "--support", texton.support,
           wholeNumber(int(kTextonSupportRange.least), int(kTextonSupportRange.most)), "64",
           "Texels a side that one impact reaches")
      .group(kTextonGroup);
  addValue(verb, "--order", texton.order, oneOf<int>({{"0", 0}, {"1", 1}, {"3", 3}}), "1",
           "Of the B-spline between texels: steps, linear, or smooth enough for bumps")
      .group(kTextonGroup);
  addValue(verb, "--impacts", material.impacts, number(kImpactsRange), "30",
           "How many impacts reach a point, in the mean")
      .group(kTextonGroup);
  const Choices<PointProcess> points{{"stratified", PointProcess::stratified},
                                     {"poisson", PointProcess::poisson}};
  addValue(verb, "--points", material.pointProcess, oneOf(points), "stratified",
           "One impact in each cell of a grid, or a Poisson process")
      .group(kTextonGroup);
  const Choices<TextonVariance> variances{{"exemplar", TextonVariance::exemplar},
                                          {"periodic", TextonVariance::periodic}};
  addValue(verb, "--variance", texton.variance, oneOf(variances), "exemplar",
           "Whose contrast the noise has: the exemplar's, or its periodic component's")
      .group(kTextonGroup);
  const Choices<TextonFit> fits{{"transport", TextonFit::transport},
                                {"projections", TextonFit::projections}};
  addValue(verb, "--fit", texton.fit, oneOf(fits), "transport",
           "By least transport distance, or by the paper's alternating projections")
      .group(kTextonGroup);
}

} // namespace

void addMethodOptions(CLI::App& verb, MethodOptions& options) {
  const Choices<Method> methods{{"tiling", Method::tiling}, {"texton", Method::texton}};
  addValue(verb, "--method", options.method, oneOf(methods), "tiling", "The noise method");
  addValue(verb, "--precision", options.bits, oneOf<int>({{"8", 8}, {"16", 16}}), "8",
           "Bits per channel of the tables; a texton's are floats of twice as many");
  addTilingOptions(verb, options.tiling);
  addTextonOptions(verb, options.texton, options.material);
}

Result<void> checkMethodOptions(const CLI::App& verb, const MethodOptions& options) {
  for (const Method other : {Method::tiling, Method::texton})
    if (const auto given = givenOf(verb, groupOf(other)); given && other != options.method)
      return Error{ErrorKind::usage,
                   *given + ": belongs to --method " + std::string(nameOf(other)) + "; with " +
                       std::string(nameOf(options.method)) + " it is not accepted"};
  return {};
}

Result<MethodBake> bakeBy(const MethodOptions& options, const std::string& name,
                          std::span<const MapExemplar> maps, Periodic borders,
                          const Progress& progress) {
  if (options.method == Method::texton) {
    TextonOptions texton = options.texton;
    texton.bits = options.bits;
    texton.progress = progress;
    Result<TextonBake> baked = bakeTexton(name, maps, texton);
    if (!baked)
      return baked.error();
    return MethodBake{std::move(baked.value().noise),
                      std::move(baked.value().tables),
                      true,
                      {},
                      std::move(baked.value().quality)};
  }
  TilingOptions tiling = options.tiling;
  tiling.bits = options.bits;
  tiling.periodic = borders;
  tiling.progress = progress;
  Result<TilingBake> baked = bakeTiling(name, maps, tiling);
  if (!baked)
    return baked.error();
  return MethodBake{std::move(baked.value().noise), std::move(baked.value().tables),
                    baked.value().exemplarWasPeriodic, std::move(baked.value().transportBounds),
                    std::nullopt};
}

} // namespace lichen::cli
