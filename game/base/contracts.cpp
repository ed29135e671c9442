#include "base/contracts.h"

#include <cstdio>
#include <cstdlib>

namespace gh {

void contract_violated(const char* kind, const char* expression, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: %s violated: %s\n", file, line, kind, expression);
    std::fflush(stderr);
    std::abort();
}

}  // namespace gh
