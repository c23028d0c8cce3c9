/* SPDX-License-Identifier: MIT
 * The plugin's headers and its shared library as a C99 host uses them: every failure below is the
 * host's mistake and comes back as a code and a message. Needs no Vulkan device. */
#include <lichen/lichen_vulkan.h>

#include <stdio.h>

static int check(int condition, const char* what) {
  if (!condition)
    fprintf(stderr, "failed: %s\n", what);
  return condition ? 0 : 1;
}

int main(void) {
  int failures = 0;
  LichenDiagnostic diagnostic;
  LichenParseInfo parse;
  LichenVulkanInfo vulkan;
  LichenSamplerProperties sampler;
  LichenBundle bundle = NULL;
  LichenVulkanContext context = NULL;
  const unsigned char notABundle[] = "not a bundle";

  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  LICHEN_INIT(parse, LICHEN_STRUCTURE_PARSE_INFO);
  LICHEN_INIT(vulkan, LICHEN_STRUCTURE_VULKAN_INFO);
  LICHEN_INIT(sampler, LICHEN_STRUCTURE_SAMPLER_PROPERTIES);

  failures += check(lichenGetVersion() == LICHEN_HEADER_VERSION, "header and library fit");

  parse.headerVersion = LICHEN_HEADER_VERSION;
  parse.bytes = notABundle;
  parse.byteCount = sizeof notABundle;
  parse.name = "c99_host";
  failures += check(lichenParseBundle(&parse, &bundle, &diagnostic) == LICHEN_ERROR_BAD_BUNDLE,
                    "what is not a bundle is refused");
  failures += check(bundle == NULL && strstr(diagnostic.text, "c99_host") != NULL,
                    "the message names the bundle");

  vulkan.headerVersion = LICHEN_HEADER_VERSION;
  failures += check(lichenVulkanCreateContext(&vulkan, &context, &diagnostic) == LICHEN_ERROR_USAGE,
                    "a context needs a device");

  failures += check(lichenGetSamplerProperties(LICHEN_SAMPLER_TABLE, &sampler) == LICHEN_SUCCESS &&
                        sampler.vkAddressMode == (uint32_t)VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                    "the table is clamped");
  failures += check(lichenGetSamplerProperties((LichenSamplerUse)2, &sampler) == LICHEN_ERROR_USAGE,
                    "there are two samplers");

  lichenVulkanDestroyContext(context);
  lichenDestroyBundle(bundle);
  return failures;
}
