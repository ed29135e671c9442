// kernels/ray_setup.inl - a ray made ready for triangles (sheared) and for boxes (slopes and padding).
//
// Padding. A triangle is hit when its rounded, sheared corners hold the ray's axis (triangle.inl), so the true
// point P of the triangle may lie off the true ray, by at most
//     e (2 R_x + 3 |S_x| R_z)  on axis x,  e = 2^-24, R_a the farthest the tree's bounds reach from the origin on a,
// and the slab arithmetic errs by at most e (3 |o| + 3 R). pad[] below is at least twice the sum; it moves the near
// planes towards the ray's start and the far planes away, so P's box is never culled. It costs nothing in the walk:
// near and far planes merely have different constants. raycore/README.md has the proof line by line.

namespace rc::kernel::RC_ISA {

struct LocalRay {
    float origin[3];
    int kx, ky, kz;  // kz: the axis the ray runs along most
    float shear_x, shear_y;
    double dz;
};

// Distances along a box ray are |displacement on axis kz|: s = t * |dz|.
struct BoxRay {
    float slope_rcp[3];
    float near_at_zero[3], far_at_zero[3];
    int near_row[3], far_row[3];
    float s_min, s_max;
    float dz_abs, s_pad;
};

static inline float absolute(float a) { return __builtin_fabsf(a); }
static inline float larger(float a, float b) { return a > b ? a : b; }

// Beyond every hit whose t is at most `t_max`.
static inline float s_limit(const BoxRay& box, float t_max) { return t_max * box.dz_abs * (1.0f + 0x1p-21f) + box.s_pad; }

static inline bool is_finite(float a) { return absolute(a) <= 0x1.fffffep127f; }

static inline bool is_good(const RayIn& ray) {
    bool finite = true, moves = false;
    for (int a = 0; a < 3; ++a) {
        finite = finite & is_finite(ray.origin[a]) & is_finite(ray.direction[a]);
        moves = moves | (ray.direction[a] != 0.0f);
    }
    return finite & moves & (ray.t_min <= ray.t_max);
}

// False when the direction has vanished or overflowed on its way into the instance's frame: such a ray misses.
static inline bool shear(const float origin[3], const float direction[3], LocalRay& ray) {
    const float dx = absolute(direction[0]), dy = absolute(direction[1]), dz = absolute(direction[2]);
    ray.kz = dx > dy ? (dx > dz ? 0 : 2) : (dy > dz ? 1 : 2);
    ray.kx = ray.kz == 2 ? 0 : ray.kz + 1;
    ray.ky = ray.kx == 2 ? 0 : ray.kx + 1;
    for (int a = 0; a < 3; ++a) ray.origin[a] = origin[a];
    const float along = direction[ray.kz];
    ray.shear_x = direction[ray.kx] / along;
    ray.shear_y = direction[ray.ky] / along;
    ray.dz = double(along);
    return along != 0.0f && is_finite(along) && is_finite(origin[0]) && is_finite(origin[1]) && is_finite(origin[2]);
}

struct TreeBounds {
    const float* min;
    const float* max;
    float extra_pad;  // what else the tree's boxes have to forgive; 0 in a BLAS
};

static inline void aim_at_boxes(const LocalRay& ray, const TreeBounds& tree, float t_min, float t_max, BoxRay& box) {
    float reach[3];
    for (int a = 0; a < 3; ++a)
        reach[a] = larger(absolute(tree.min[a] - ray.origin[a]), absolute(tree.max[a] - ray.origin[a]));

    const float sign = ray.dz < 0 ? -1.0f : 1.0f;
    float slope[3];
    slope[ray.kx] = ray.shear_x * sign;
    slope[ray.ky] = ray.shear_y * sign;
    slope[ray.kz] = sign;
    for (int a = 0; a < 3; ++a) {
        const float steepness = absolute(slope[a]);
        const float pad = (absolute(ray.origin[a]) + reach[a]) * 0x1p-21f +
                          reach[ray.kz] * (steepness * 0x1p-21f + 0x1p-39f) + (tree.extra_pad + 0x1p-100f);
        // A slope below 2^-40 strays from the true ray by less than the last term but one.
        const bool forward = !__builtin_signbit(slope[a]);
        const float bounded = larger(steepness, 0x1p-40f);
        box.slope_rcp[a] = 1.0f / (forward ? bounded : -bounded);
        const float towards = forward ? pad : -pad;
        box.near_at_zero[a] = -(ray.origin[a] + towards) * box.slope_rcp[a];
        box.far_at_zero[a] = -(ray.origin[a] - towards) * box.slope_rcp[a];
        box.near_row[a] = 2 * a + !forward;
        box.far_row[a] = 2 * a + forward;
    }
    box.dz_abs = absolute(float(ray.dz));
    box.s_pad = reach[ray.kz] * 0x1p-21f + 0x1p-100f;
    box.s_min = t_min * box.dz_abs;
    box.s_min -= absolute(box.s_min) * 0x1p-21f + box.s_pad;
    if (!(box.s_min > -0x1p127f)) box.s_min = -0x1p127f;
    box.s_max = s_limit(box, t_max);
}

// The ray in the instance's own frame; the direction is not made unit, so t keeps its meaning. Rounded once.
static inline void to_local(const double m[12], const RayIn& ray, float origin[3], float direction[3]) {
    const double ox = double(ray.origin[0]), oy = double(ray.origin[1]), oz = double(ray.origin[2]);
    const double dx = double(ray.direction[0]), dy = double(ray.direction[1]), dz = double(ray.direction[2]);
    for (int r = 0; r < 3; ++r) {
        const double* row = m + 4 * r;
        origin[r] = float(((row[0] * ox + row[1] * oy) + row[2] * oz) + row[3]);
        direction[r] = float((row[0] * dx + row[1] * dy) + row[2] * dz);
    }
}

}  // namespace rc::kernel::RC_ISA
