#include "mortise/cases/summary/provenance.hpp"

#ifndef MORTISE_VERSION
#define MORTISE_VERSION "unknown"
#endif
#ifndef MORTISE_GIT
#define MORTISE_GIT "unknown"
#endif
#ifndef MORTISE_GIT_DIRTY
#define MORTISE_GIT_DIRTY 0
#endif
#ifndef MORTISE_COMPILER
#ifdef __VERSION__
#define MORTISE_COMPILER __VERSION__
#else
#define MORTISE_COMPILER "unknown"
#endif
#endif
#ifndef MORTISE_FLAGS
#define MORTISE_FLAGS "unknown"
#endif

namespace mortise {

Provenance provenance() {
  return {MORTISE_VERSION, MORTISE_GIT, MORTISE_GIT_DIRTY != 0, MORTISE_COMPILER, MORTISE_FLAGS};
}

}  // namespace mortise
