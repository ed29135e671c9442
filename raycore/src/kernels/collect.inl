// kernels/collect.inl - boxes around triangles, with their slack: the inner loop of collect_refs.cpp.

namespace rc::kernel::RC_ISA {

static std::uint64_t box_triangles(const MeshArrays& mesh, std::uint64_t vertices, std::uint64_t first,
                                   std::uint64_t end, BuildRef* refs, GrowingBox& bounds) {
    std::uint64_t kept = 0;
    for (std::uint64_t i = first; i < end; ++i) {
        const std::uint32_t* t = mesh.triangles + 3 * i;
        if (!(t[0] < vertices && t[1] < vertices && t[2] < vertices)) continue;
        const Quad a = corner_of(mesh, t[0]), b = corner_of(mesh, t[1]), c = corner_of(mesh, t[2]);
        if (!is_worth_keeping(a, b, c)) continue;
        const Quad least = lesser(a, lesser(b, c)), most = greater(a, greater(b, c)), extent = most - least;
        const float of_two = extent[0] > extent[1] ? extent[0] : extent[1];
        const float slack = (of_two > extent[2] ? of_two : extent[2]) * kSlack;
        const Oct box = __builtin_shufflevector(-least, most, 0, 1, 2, 3, 4, 5, 6, 7);
        grow(bounds, box);
        store_as<Oct>(&refs[kept], without_items(box + oct_of(slack)));
        refs[kept++].item = std::uint32_t(i);
    }
    return kept;
}

}  // namespace rc::kernel::RC_ISA
