// unfilled.h - a vector whose new elements hold nothing yet: for what several threads are about to fill.
//
// Zeroing a gigabyte first is a second's work of one thread, most of it the first touch of every page.
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace rc {

template <class T>
struct UnfilledAllocator : std::allocator<T> {
    template <class Other>
    struct rebind {
        using other = UnfilledAllocator<Other>;
    };
    UnfilledAllocator() = default;
    template <class Other>
    explicit UnfilledAllocator(const UnfilledAllocator<Other>&) {}

    template <class Element>
    void construct(Element* at) {
        ::new (static_cast<void*>(at)) Element;
    }
    template <class Element, class... Arguments>
    void construct(Element* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) Element(std::forward<Arguments>(arguments)...);
    }
};

template <class T>
using Unfilled = std::vector<T, UnfilledAllocator<T>>;

}  // namespace rc
