#include "base/plane_block.h"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace gh {

namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;
constexpr std::size_t kCacheLine = 64;

}  // namespace

std::shared_ptr<std::byte> make_plane_block(std::size_t bytes) {
    // The last page may be half empty.
    const std::size_t huge = (bytes + kHugePage / 2) / kHugePage * kHugePage;
    const std::align_val_t alignment{huge > 0 ? kHugePage : kCacheLine};
    auto* const block = static_cast<std::byte*>(::operator new(bytes > huge ? bytes : huge, alignment));
#ifdef MADV_HUGEPAGE
    if (huge > 0) (void)::madvise(block, huge, MADV_HUGEPAGE);  // where it is refused, pages stay small
#endif
    return {block, [alignment](std::byte* at) { ::operator delete(at, alignment); }};
}

}  // namespace gh
