// kernels/share.inl - the corners that a leaf's triangles have in common, found once at build.

namespace rc::kernel::RC_ISA {

typedef std::uint32_t Words __attribute__((vector_size(32)));
inline constexpr std::uint32_t kWordsAtOnce = sizeof(Words) / sizeof(std::uint32_t);
inline constexpr std::uint32_t kVectors = kMostOfLeaf / kWordsAtOnce;

// All corners at once against one after the other, from the last: what is left says which is the first like it. Corners
// are told apart by so many words each.
template <std::size_t kKeys>
static inline void find_first(const std::uint32_t (&keys)[kKeys][kMostOfLeaf], std::uint32_t n,
                              std::uint32_t (&first)[kMostOfLeaf]) {
    Words found[kVectors] = {};
    for (std::uint32_t i = n; i-- > 0;) {
        for (std::uint32_t k = 0; k < kVectors; ++k) {
            Words is_same = load_as<Words>(keys[0] + kWordsAtOnce * k) == Words{} + keys[0][i];
            for (std::size_t w = 1; w < kKeys; ++w)
                is_same &= load_as<Words>(keys[w] + kWordsAtOnce * k) == Words{} + keys[w][i];
            found[k] = is_same ? Words{} + i : found[k];
        }
    }
    __builtin_memcpy(first, found, sizeof(found));
}

static inline void find_first(const std::uint32_t (&vertices)[kMostOfLeaf], std::uint32_t n,
                              const float* positions, std::uint32_t (&first)[kMostOfLeaf]) {
    alignas(32) std::uint32_t keys[3][kMostOfLeaf] = {};
    for (std::uint32_t i = 0; i < n; ++i) {
        std::uint32_t position[3];
        __builtin_memcpy(position, positions + 3 * std::uint64_t{vertices[i]}, sizeof(position));
        for (int a = 0; a < 3; ++a) keys[a][i] = position[a];
    }
    find_first(keys, n, first);
}

static void share_corners(const LeafItems& leaf, const MeshArrays& mesh, bool by_vertex,
                          SharedCorners& shared) {
    constexpr std::uint32_t kAhead = 12;  // items further lies what is asked for next
    const std::uint32_t n = leaf.count;
    // First corners first: as many as triangles at most, so they are among the first eight (simd_*.h, pick_low).
    alignas(32) std::uint32_t vertices[1][kMostOfLeaf] = {}, first[kMostOfLeaf];
    for (std::uint32_t t = 0; t < n; ++t) {
        const std::uint32_t at = leaf.first + t;
        const std::uint32_t* corners = mesh.triangles + 3 * std::uint64_t{leaf.items[at]};
        for (std::uint32_t c = 0; c < 3; ++c) vertices[0][c * n + t] = corners[c];
        if (at + kAhead < leaf.size)
            __builtin_prefetch(mesh.triangles + 3 * std::uint64_t{leaf.items[at + kAhead]});
    }
    by_vertex ? find_first(vertices, 3 * n, first) : find_first(vertices[0], 3 * n, mesh.positions, first);
    std::uint32_t name[kMostOfLeaf], count = 0;
    for (std::uint32_t i = 0; i < 3 * n; ++i) {
        shared.vertices[count] = vertices[0][i];
        name[i] = count;
        name[i] = name[first[i]];
        count += first[i] == i;
    }
    shared.count = count;
    for (std::uint32_t t = 0; t < n; ++t)
        shared.halves[t] = std::uint16_t(name[t] | name[n + t] << kCornerBits |
                                         name[2 * n + t] << (2 * kCornerBits) | kIsMet);
    shared.halves[0] = std::uint16_t(shared.halves[0] | (n - 1) << kCountShift);
}

}  // namespace rc::kernel::RC_ISA
