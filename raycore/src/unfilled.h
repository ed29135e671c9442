// unfilled.h - a vector whose new elements hold nothing yet: for what several threads are about to fill.
//
// Zeroing a gigabyte first is a second's work of one thread, most of it the first touch of every page.
//
// What is large asks for huge pages (huge_pages.cpp): a walk through a tree of tens of megabytes otherwise misses the
// processor's table of pages nearly as often as its caches, and a build touches five hundred times as many pages.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace rc {

inline constexpr std::size_t kHugePage = std::size_t{1} << 21;  // of x86-64 and most of AArch64

// Memory aligned to kHugePage, which the system is asked to back by huge pages; it may refuse.
[[nodiscard]] void* allocate_in_huge_pages(std::size_t bytes);
void free_huge_pages(void* at);

template <class T>
struct UnfilledAllocator : std::allocator<T> {
    template <class Other>
    struct rebind {
        using other = UnfilledAllocator<Other>;
    };
    UnfilledAllocator() = default;
    template <class Other>
    explicit UnfilledAllocator(const UnfilledAllocator<Other>&) {}

    [[nodiscard]] T* allocate(std::size_t n) {
        if (is_large(n)) return static_cast<T*>(allocate_in_huge_pages(n * sizeof(T)));
        return std::allocator<T>::allocate(n);
    }
    void deallocate(T* at, std::size_t n) {
        if (is_large(n)) return free_huge_pages(at);
        std::allocator<T>::deallocate(at, n);
    }

    template <class Element>
    void construct(Element* at) {
        ::new (static_cast<void*>(at)) Element;
    }
    template <class Element, class... Arguments>
    void construct(Element* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) Element(std::forward<Arguments>(arguments)...);
    }

  private:
    static bool is_large(std::size_t n) { return n >= kHugePage / sizeof(T); }
};

template <class T>
using Unfilled = std::vector<T, UnfilledAllocator<T>>;

}  // namespace rc
