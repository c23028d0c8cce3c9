// SPDX-License-Identifier: MIT
// For passes that evaluate one map: `evaluated(image, table, ...)` with the descriptors of the role
// that the specialization constant names.
layout(constant_id = 1) const int kRole = LICHEN_BASE_COLOR;

#define LICHEN_EVALUATE_ROLE(result, role, point)                                                  \
  if (kRole == role)                                                                               \
  result = evaluated(lichenImage##role, lichenTable##role, point)

#define LICHEN_EVALUATE(result, point)                                                             \
  LICHEN_EVALUATE_ROLE(result, 0, point);                                                          \
  LICHEN_EVALUATE_ROLE(result, 1, point);                                                          \
  LICHEN_EVALUATE_ROLE(result, 2, point);                                                          \
  LICHEN_EVALUATE_ROLE(result, 3, point);                                                          \
  LICHEN_EVALUATE_ROLE(result, 4, point);                                                          \
  LICHEN_EVALUATE_ROLE(result, 5, point)
