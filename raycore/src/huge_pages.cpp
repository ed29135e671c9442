#include "unfilled.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rc {

void* allocate_in_huge_pages(std::size_t bytes) {
    void* at = ::operator new(bytes, std::align_val_t{kHugePage});
#ifdef MADV_HUGEPAGE
    // Only whole ones, so that no more memory is held than was asked for. Where the system refuses, pages stay small.
    const std::size_t whole = bytes / kHugePage * kHugePage;
    (void)::madvise(at, whole, MADV_HUGEPAGE);
#endif
    return at;
}

void free_huge_pages(void* at) {
    ::operator delete(at, std::align_val_t{kHugePage});
}

}  // namespace rc
