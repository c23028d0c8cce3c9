// SPDX-License-Identifier: MIT
// Options of each method -> its bake.
#include "method_options.h"

#include "method_group.h"

namespace lichen::cli {
namespace {

void addTilingOptions(CLI::App& verb, TilingOptions& tiling) {
  const Choices<TransportEffort> efforts{{"fast", TransportEffort::fast},
                                         {"default", TransportEffort::standard},
                                         {"exact", TransportEffort::exact}};
  addValue(verb, "--transport", tiling.transport, oneOf(efforts), "default",
           "How near to optimal colours are matched")
      .group(groupOf(Method::tiling));
  const Choices<LookupTable> luts{{"joint", LookupTable::joint},
                                  {"separable", LookupTable::separable}};
  addValue(verb, "--lut", tiling.lut, oneOf(luts), "joint",
           "One table of all colours, or a small one for each axis of colour")
      .group(groupOf(Method::tiling));
  const Choices<GaussianOnly> gaussian{
      {"auto", GaussianOnly::detect}, {"yes", GaussianOnly::yes}, {"no", GaussianOnly::no}};
  addValue(verb, "--gaussian", tiling.gaussian, oneOf(gaussian), "auto",
           "Whether the exemplar's values are Gaussian, and need no table")
      .group(groupOf(Method::tiling));
}

} // namespace

void addTextonOptions(CLI::App& verb, TextonOptions& texton, MaterialNoise& material) {
  addValue(verb, "--support", texton.support,
           wholeNumber(int(kTextonSupportRange.least), int(kTextonSupportRange.most)), "64",
           "Texels a side that one impact reaches")
      .group(groupOf(Method::texton));
  addValue(verb, "--order", texton.order, oneOf<int>({{"0", 0}, {"1", 1}, {"3", 3}}), "1",
           "Of the B-spline between texels: steps, linear, or smooth enough for bumps")
      .group(groupOf(Method::texton));
  addValue(verb, "--impacts", material.impacts, number(kImpactsRange), "30",
           "How many impacts reach a point, in the mean")
      .group(groupOf(Method::texton));
  addValue(verb, "--points", material.pointProcess, pointProcess(), "stratified",
           "One impact in each cell of a grid, or a Poisson process")
      .group(groupOf(Method::texton));
  const Choices<TextonVariance> variances{{"exemplar", TextonVariance::exemplar},
                                          {"periodic", TextonVariance::periodic}};
  addValue(verb, "--variance", texton.variance, oneOf(variances), "exemplar",
           "Whose contrast the noise has: the exemplar's, or its periodic component's")
      .group(groupOf(Method::texton));
}

void addMethodOptions(CLI::App& verb, MethodOptions& options) {
  const Choices<Method> methods{{"tiling", Method::tiling}, {"texton", Method::texton}};
  addValue(verb, "--method", options.method, oneOf(methods), "tiling", "The noise method");
  addValue(verb, "--precision", options.bits, oneOf<int>({{"8", 8}, {"16", 16}}), "8",
           "Bits per channel of the tables; a texton's are floats of twice as many");
  addTilingOptions(verb, options.tiling);
  addTextonOptions(verb, options.texton, options.material);
  const Choices<TextonFit> fits{{"transport", TextonFit::transport},
                                {"projections", TextonFit::projections}};
  addValue(verb, "--fit", options.texton.fit, oneOf(fits), "transport",
           "By least transport distance, or by the paper's alternating projections")
      .group(groupOf(Method::texton));
}

Result<void> checkMethodOptions(const CLI::App& verb, const MethodOptions& options) {
  const std::optional<ForeignOption> foreign = foreignOption(verb, options.method);
  if (!foreign)
    return {};
  return Error{ErrorKind::usage, foreign->name + ": belongs to --method " +
                                     std::string(nameOf(foreign->method)) + "; with " +
                                     std::string(nameOf(options.method)) + " it is not accepted"};
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
