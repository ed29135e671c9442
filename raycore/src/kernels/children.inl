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

// The nearest child that is met; the others go onto the stack, the next nearest on top.
template <bool kGuess>
static inline std::uint32_t nearest_child(const Places& places, const WideNode& node,
                                          const float near[kWidth], std::uint32_t met, Stack& stack,
                                          int& top) {
    const auto first = std::uint32_t(__builtin_ctz(met));
    std::uint32_t nearest = child_at<kGuess>(node, first);
    float nearest_at = near[first];
    met &= met - 1;
    if (met == 0) return nearest;
    const int base = top;
    do {  // insertion, farthest first: two or three are met on average
        const int lane = __builtin_ctz(met);
        met &= met - 1;
        const std::uint32_t item = node.child[lane];
        const float at = near[lane];
        const bool swap = at < nearest_at;
        const std::uint32_t farther = swap ? nearest : item;
        const float farther_at = swap ? nearest_at : at;
        nearest = swap ? item : nearest;
        nearest_at = swap ? at : nearest_at;
        prefetch<3>(places, farther);
        int i = top++;
        for (; i > base && stack.near[i - 1] < farther_at; --i) {
            stack.item[i] = stack.item[i - 1];
            stack.near[i] = stack.near[i - 1];
        }
        stack.item[i] = farther;
        stack.near[i] = farther_at;
    } while (met != 0);
    return nearest;
}

// The child likeliest to end an any-hit walk, which is the highest lane (collapse.cpp); the others go onto the stack.
template <bool kGuess>
static inline std::uint32_t likeliest_child(const Places& places, const WideNode& node, std::uint32_t met,
                                            Stack& stack, int& top) {
    const std::uint32_t first = 31u - std::uint32_t(__builtin_clz(met));
    const std::uint32_t others = met ^ (1u << first);
    if (others != 0) {
        store(stack.item + top, compress(load(node.child), met));  // the first as well, above the top
        top += __builtin_popcount(others);
        prefetch<4>(places, node.child[31u - std::uint32_t(__builtin_clz(others))]);
    }
    return child_at<kGuess>(node, first);
}

// Which of a node's children `met`, of which there is one at least, comes next; the others go onto the stack.
template <class Sink, bool kGuess>
static inline std::uint32_t next_child(const Places& places, const WideNode& node, const Entrances& e,
                                       std::uint32_t met, Stack& stack, int& top) {
    if constexpr (Sink::kIsAny) return likeliest_child<kGuess>(places, node, met, stack, top);
    alignas(32) float near[kWidth];
    store(near, e.enter);
    return nearest_child<kGuess>(places, node, near, met, stack, top);
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
