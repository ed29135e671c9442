// kernels/children.inl - which of a node's children a lone ray opens next.
//
// A lone ray waits for itself: from a node's address to its child's take thirty cycles, of which the comparison's way
// into a register and the look-up of the child are half. So nothing is looked up: the processor is made to guess the lane by a
// jump, goes on with that child, and finds out later. It is right often enough even for diffuse rays, for finding out
// by a look-up takes as long as being wrong. Only above instances is it wrong too often: eight boxes side by side, of
// which a ray meets one or two, have no order that could be learned.

namespace rc::kernel::RC_ISA {
namespace {

// node.child[lane]; where it is guessed, by a jump to one of eight loads.
template <bool kGuess>
static inline std::uint32_t child_at(const WideNode& node, std::uint32_t lane) {
    if constexpr (!kGuess) return node.child[lane];
    std::uint32_t item;
    const auto take = [&](int i) {
        item = node.child[i];
        asm("" : "+r"(item));  // or compilers make one look-up of the eight loads
    };
    switch (lane & (kWidth - 1)) {
        case 0:
            take(0);
            break;
        case 1:
            take(1);
            break;
        case 2:
            take(2);
            break;
        case 3:
            take(3);
            break;
        case 4:
            take(4);
            break;
        case 5:
            take(5);
            break;
        case 6:
            take(6);
            break;
        default:
            take(7);
    }
    return item;
}

// What a closest-hit walk has yet to open, the nearest on top; kEmptyTree at the bottom, nearer than anything.
struct Waiting {
    std::uint32_t item;
    float near;
};

// An any-hit walk keeps no distances: what it is told to stop at never comes nearer.
template <bool kIsAny>
struct EntryOf {
    using Type = Waiting;
};
template <>
struct EntryOf<true> {
    using Type = std::uint32_t;
};
template <class Sink>
using Entry = typename EntryOf<Sink::kIsAny>::Type;

inline constexpr int kEntries = kStackSize + kWidth;  // likeliest_child writes eight, whatever they mean

// To be opened in any case.
static inline void put(Waiting*& top, std::uint32_t item) {
    *top++ = {item, -__builtin_inff()};
}
static inline void put(std::uint32_t*& top, std::uint32_t item) {
    *top++ = item;
}

// The top of a stack with nothing to open.
template <class AnyEntry>
static inline AnyEntry* start(AnyEntry* stack) {
    put(stack, kEmptyTree);
    return stack;
}

// The next item that may hold something nearer than s_max.
static inline std::uint32_t pop(Waiting*& top, float s_max) {
    do --top;
    while (top->near > s_max);
    return top->item;
}
static inline std::uint32_t pop(std::uint32_t*& top, float) {
    return *--top;
}

// The nearest child that is met; the others go onto the stack, the next nearest on top.
template <bool kGuess>
static inline std::uint32_t next_child(const Places& places, const WideNode& node, const Entrances& e,
                                       std::uint32_t met, Waiting*& top) {
    alignas(32) float near[kWidth];
    store(near, e.enter);
    const auto first = std::uint32_t(__builtin_ctz(met));
    Waiting nearest{child_at<kGuess>(node, first), near[first]};
    met &= met - 1;
    if (met == 0) return nearest.item;
    Waiting* const base = top;
    do {  // insertion, farthest first: two or three are met on average
        const int lane = __builtin_ctz(met);
        met &= met - 1;
        Waiting farther{node.child[lane], near[lane]};
        if (farther.near < nearest.near) {
            const Waiting nearer = farther;
            farther = nearest;
            nearest = nearer;
        }
        prefetch<2>(places, farther.item);
        Waiting* at = top++;
        for (; at > base && at[-1].near < farther.near; --at) *at = at[-1];
        *at = farther;
    } while (met != 0);
    return nearest.item;
}

// The child likeliest to end an any-hit walk, which is the highest lane (collapse.cpp); the others go onto the stack.
template <bool kGuess>
static inline std::uint32_t next_child(const Places& places, const WideNode& node, const Entrances&,
                                       std::uint32_t met, std::uint32_t*& top) {
    const std::uint32_t first = 31u - std::uint32_t(__builtin_clz(met));
    const std::uint32_t others = met ^ (1u << first);
    if (others != 0) {
        store(top, compress(load(node.child), met));  // the first as well, above the top
        top += __builtin_popcount(others);
        prefetch<4>(places, node.child[31u - std::uint32_t(__builtin_clz(others))]);
    }
    return child_at<kGuess>(node, first);
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
