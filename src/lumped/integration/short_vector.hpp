// CVODES' vector for the few states of a network: a serial N_Vector whose arithmetic is plain loops without the
// case distinctions of the library's own, which cost more than the arithmetic itself at a dozen entries.
// CVODES spends some hundred such operations on a step. Clones are of the same kind.
// Source: Hindmarsh et al., User documentation for CVODES, chapter "Vector data structures".
#pragma once

#include <nvector/nvector_serial.h>

namespace valsalva::lumped {

/// `count` entries without values; nullptr if memory is out. To be freed by N_VDestroy.
N_Vector new_short_vector(sunindextype count, SUNContext context);

}  // namespace valsalva::lumped
