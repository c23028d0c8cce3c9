/* SPDX-License-Identifier: MIT
 * The plugin's headers and its shared library as a C99 host uses them: every failure below is the
 * host's mistake and comes back as a code and a message. Needs no Vulkan device. */
#include <lichen/lichen_vulkan.h>

#include <lichen_interface.h>
#include <stdio.h>

static int check(int condition, const char* what) {
  if (!condition)
    fprintf(stderr, "failed: %s\n", what);
  return condition ? 0 : 1;
}

/* The layout of version 1.0 on 64-bit systems: members are added after the last, and none moves.
 * The last ends the struct: a member that took the place of padding would leave the size as it is,
 * and an older library would not notice it. */
#define KEEPS(Struct, lastMember, bytes, offset)                                                   \
  check(sizeof(Struct) >= (bytes) && offsetof(Struct, lastMember) == (offset) &&                   \
            (offset) + sizeof(((Struct*)0)->lastMember) == (bytes),                                \
        #Struct " keeps its layout")

static int checkLayouts(void) {
  int failures = 0;
  failures += KEEPS(LichenDiagnostic, text, 512, 16);
  failures += KEEPS(LichenParseInfo, name, 48, 40);
  failures += KEEPS(LichenBundleProperties, reserved, 32, 28);
  failures += KEEPS(LichenNoiseProperties, mappings, 48, 44);
  failures += KEEPS(LichenMapProperties, reserved, 48, 44);
  failures += KEEPS(LichenMaterialProperties, reserved, 56, 52);
  failures += KEEPS(LichenImageProperties, byteCount, 88, 80);
  failures += KEEPS(LichenCopy, depth, 48, 44);
  failures += KEEPS(LichenSamplerProperties, reserved, 40, 36);
  failures += KEEPS(LichenBinding, image, 32, 28);
  failures += KEEPS(LichenMaterialParameters, noiseSummary, 608, 144);
  failures += KEEPS(LichenPlacement, reserved, 64, 60);
  failures += KEEPS(LichenVulkanFunctions, updateDescriptorSets, 216, 208);
  failures += KEEPS(LichenMemoryRequest, optimalTiling, 48, 44);
  failures += KEEPS(LichenDeviceMemory, handle, 48, 40);
  failures += KEEPS(LichenDeviceAllocator, release, 40, 32);
  failures += KEEPS(LichenVulkanInfo, reserved, 96, 92);
  failures += check(LICHEN_BINDING_COUNT == LICHEN_SET_BINDINGS, "the set has all bindings");
  return failures;
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

  if (sizeof(void*) == 8)
    failures += checkLayouts();
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
