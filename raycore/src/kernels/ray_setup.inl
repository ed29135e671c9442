// kernels/ray_setup.inl - a ray made ready for triangles (sheared) and for boxes (slopes and padding).
//
// Padding. A triangle is hit when its rounded, sheared corners hold the ray's axis (triangle.inl), so the true
// point P of the triangle may lie off the true ray, by at most
//     e (5 |S_x| s + 6 E)  on axis x,  e = 2^-24, s its distance along the ray's axis, E the triangle's largest extent,
// and the slab arithmetic errs by at most e (4 |o| + 5 |S_x| s). What grows with E is in the boxes (kSlack); what grows
// with s moves planes by a share of their distance, what grows with o by a constant. Neither costs anything in the walk:
// near and far planes merely have different factors and constants. raycore/README.md has the proof line by line.
//
// It is worth being sharp: rays that start on a surface stand 28 e |o| off it, and boxes padded by more than that, say
// by shares of the whole tree's size, make every one of them look into its own leaf again.

namespace rc::kernel::RC_ISA {
namespace {

// Three axes and a lane that means nothing; the compiler's own vectors, since every ISA has four floats.
typedef float Quad __attribute__((vector_size(16)));
typedef std::int32_t QuadBits __attribute__((vector_size(16)));

static inline Quad load_quad(const float* p) {
    Quad q;
    __builtin_memcpy(&q, p, sizeof(q));
    return q;
}
static inline Quad quad_of(float a) {
    return Quad{a, a, a, a};
}
static inline Quad quad_max(Quad a, Quad b) {
    return a > b ? a : b;
}
static inline Quad with_bits(QuadBits bits) {
    return reinterpret_cast<Quad>(bits);
}
static inline QuadBits sign_of(Quad a) {
    return reinterpret_cast<QuadBits>(a) & QuadBits{INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN};
}
static inline Quad absolute(Quad a) {
    return with_bits(reinterpret_cast<QuadBits>(a) ^ sign_of(a));
}
static inline Quad with_sign(Quad a, QuadBits sign) {
    return with_bits(reinterpret_cast<QuadBits>(a) | sign);
}

struct LocalRay {
    Quad origin;
    Quad direction;
    int kx, ky, kz;  // kz: the axis the ray runs along most
    float shear_x, shear_y;
    float dz, dz_abs;
    float at_kx, at_ky, at_kz;  // of the origin
};

// What depends on the signs of a direction alone. Bit a of an octant: the ray runs down axis a.
struct alignas(64) Octant {
    std::int32_t near_row[3], far_row[3];  // byte offsets into WideNode::bounds
};

struct Octants {
    Octant of[8];
    constexpr Octants() : of{} {
        constexpr std::int32_t kRow = sizeof(float) * kWidth;
        for (std::uint32_t o = 0; o < 8; ++o) {
            for (int a = 0; a < 3; ++a) {
                const bool is_down = (o >> a & 1) != 0;
                of[o].near_row[a] = (2 * a + (is_down ? 1 : 0)) * kRow;
                of[o].far_row[a] = (2 * a + (is_down ? 0 : 1)) * kRow;
            }
        }
    }
};
inline constexpr Octants kOctants;

// Distances along a box ray are |displacement on axis kz|: s = t * |dz|.
struct BoxRay {
    Quad near_rcp, far_rcp, near_at_zero, far_at_zero;
    float s_min, s_max;
    float dz_abs, s_pad;
    const Octant* octant;
};

static inline float absolute(float a) {
    return __builtin_fabsf(a);
}
static inline float larger(float a, float b) {
    return a > b ? a : b;
}

// Beyond every hit whose t is at most `t_max`.
static inline float s_limit(const BoxRay& box, float t_max) {
    return t_max * box.dz_abs * (1.0f + 0x1p-21f) + box.s_pad;
}

// Axes in the order of a ray that runs mostly along kz.
inline constexpr int kNextAxis[3] = {1, 2, 0};

inline constexpr float kLargest = 0x1.fffffep127f;  // t beyond it, either way, is infinite: a miss

static inline float finite_limit(float t_max) {
    return t_max < kLargest ? t_max : kLargest;
}
static inline float finite_start(float t_min) {
    return t_min > -kLargest ? t_min : -kLargest;
}

// x - x is NaN for what is not finite, and zero for all else.
static inline float zero_if_finite(const float v[3]) {
    return ((v[0] - v[0]) + (v[1] - v[1])) + (v[2] - v[2]);
}

static inline bool is_good(const RayIn& ray) {
    const float zero = zero_if_finite(ray.origin) + zero_if_finite(ray.direction);
    const bool moves = (ray.direction[0] != 0.0f) | (ray.direction[1] != 0.0f) | (ray.direction[2] != 0.0f);
    return (zero == 0.0f) & moves & (ray.t_min <= ray.t_max);
}

// Whether a ray is fit to be asked after its way into an instance's frame: there its direction may have vanished, or
// something may have overflowed. Such a ray misses.
static inline bool has_arrived(const float* origin, const float* direction) {
    const float farther = larger(absolute(direction[0]), absolute(direction[1]));
    const bool moves = larger(farther, absolute(direction[2])) != 0.0f;
    const bool is_finite = zero_if_finite(origin) + zero_if_finite(direction) == 0.0f;
    return moves & is_finite;
}

// `origin` and `direction` are finite, the latter not zero, and read four wide.
static inline void shear(const float* origin, const float* direction, LocalRay& ray) {
    static constexpr int kNext[3] = {1, 2, 0}, kAfterNext[3] = {2, 0, 1};
    ray.origin = load_quad(origin);
    ray.direction = load_quad(direction);
    const Quad size = absolute(ray.direction);
    const float dx = size[0], dy = size[1], dz = size[2];
    const int of_two = dx > dy ? 0 : 1;  // no branches: which axis it is can not be predicted
    const float larger_of_two = larger(dx, dy);
    ray.kz = larger_of_two > dz ? of_two : 2;
    ray.dz_abs = larger(larger_of_two, dz);
    ray.kx = kNext[ray.kz];
    ray.ky = kAfterNext[ray.kz];
    ray.dz = direction[ray.kz];
    const Quad slope = ray.direction / quad_of(ray.dz);
    float slopes[4];
    __builtin_memcpy(slopes, &slope, sizeof(slope));
    ray.shear_x = slopes[ray.kx];
    ray.shear_y = slopes[ray.ky];
    ray.at_kx = origin[ray.kx];
    ray.at_ky = origin[ray.ky];
    ray.at_kz = origin[ray.kz];
}

struct TreeBounds {
    const float* min;
    const float* max;
};

// How far a ray's planes are moved.
struct Padding {
    Quad pad;      // across
    float s_pad;   // along
    float spread;  // in shares of their distance
};

inline constexpr float kLeastPad = 0x1p-100f;  // what underflows

// The farthest the tree's bounds lie from the origin along the ray's axis.
static inline float reach_along(const TreeBounds& tree, const LocalRay& ray) {
    return larger(absolute(tree.min[ray.kz] - ray.at_kz), absolute(tree.max[ray.kz] - ray.at_kz));
}

// For boxes without slack around them, and for rays that may meet something behind their origin: by what the bounds'
// farthest points may err. A slope below 2^-40 strays from the true ray by less than the term with 2^-39.
static inline Padding wide_padding(const LocalRay& ray, const TreeBounds& tree, float extra_pad) {
    const Quad reach =
        quad_max(absolute(load_quad(tree.min) - ray.origin), absolute(load_quad(tree.max) - ray.origin));
    const float reach_z = reach_along(tree, ray);
    return {(absolute(ray.origin) + reach) * quad_of(0x1p-21f) +
                quad_of((0x1p-21f + 0x1p-39f) * reach_z + (extra_pad + kLeastPad)),
            reach_z * 0x1p-21f + kLeastPad, 0.0f};
}

// For boxes with their triangles' slack around them: no more than a point's own way from the origin.
static inline Padding sharp_padding(const LocalRay& ray, const TreeBounds& tree) {
    const float reach_z = reach_along(tree, ray);
    return {absolute(ray.origin) * quad_of(0x1p-21f) + quad_of(0x1p-39f * reach_z + kLeastPad), kLeastPad,
            0x1p-20f};
}

static inline void aim(const LocalRay& ray, const Padding& padding, float t_min, float t_max, BoxRay& box) {
    const QuadBits sign = sign_of(ray.direction);
    Quad length = quad_of(ray.dz_abs);
    Quad size = quad_max(absolute(ray.direction), quad_of(ray.dz_abs * 0x1p-40f));
    if (ray.dz_abs < 0x1p-80f) {  // the product may have vanished
        size = quad_max(absolute(ray.direction / length), quad_of(0x1p-40f));
        length = quad_of(1.0f);
    }
    const Quad rcp = with_sign(length / size, sign);
    const Quad towards = with_sign(padding.pad, sign);
    box.near_rcp = rcp * quad_of(1.0f - padding.spread);
    box.far_rcp = rcp * quad_of(1.0f + padding.spread);
    box.near_at_zero = -(ray.origin + towards) * box.near_rcp;
    box.far_at_zero = -(ray.origin - towards) * box.far_rcp;
    box.octant = &kOctants.of[(sign[0] < 0 ? 1 : 0) | (sign[1] < 0 ? 2 : 0) | (sign[2] < 0 ? 4 : 0)];

    box.dz_abs = ray.dz_abs;
    box.s_pad = padding.s_pad;
    box.s_min = t_min * box.dz_abs;
    box.s_min -= absolute(box.s_min) * 0x1p-21f + box.s_pad;
    if (!(box.s_min > -0x1p127f)) box.s_min = -0x1p127f;
    box.s_max = s_limit(box, t_max);
}

// Makes a ray ready for the boxes of the top-level tree, which forgive `extra_pad` more.
static inline void aim_at_instances(const LocalRay& ray, const TreeBounds& tree, float extra_pad, float t_min,
                                    float t_max, BoxRay& box) {
    aim(ray, wide_padding(ray, tree, extra_pad), t_min, t_max, box);
}

// Out of the way of all other rays, of which a hundredth of the time would be lost otherwise.
__attribute__((noinline)) static void aim_also_behind(const LocalRay& ray, const TreeBounds& tree,
                                                      float t_min, float t_max, BoxRay& box) {
    aim(ray, wide_padding(ray, tree, 0.0f), t_min, t_max, box);
}

// Makes a ray ready for a BLAS's boxes.
static inline void aim_at_boxes(const LocalRay& ray, const TreeBounds& tree, float t_min, float t_max,
                                BoxRay& box) {
    if (__builtin_expect(t_min < 0.0f, 0)) return aim_also_behind(ray, tree, t_min, t_max, box);
    aim(ray, sharp_padding(ray, tree), t_min, t_max, box);
}

// The ray in the instance's own frame; the direction is not made unit, so t keeps its meaning. Rounded once.
static inline void to_local(const double (&m)[4][4], const RayIn& ray, float origin[4], float direction[4]) {
    typedef double Column __attribute__((vector_size(32)));
    Column x, y, z, offset;
    __builtin_memcpy(&x, m[0], sizeof(x));
    __builtin_memcpy(&y, m[1], sizeof(y));
    __builtin_memcpy(&z, m[2], sizeof(z));
    __builtin_memcpy(&offset, m[3], sizeof(offset));
    const auto sum = [&](const float v[3]) {
        const double vx = double(v[0]), vy = double(v[1]), vz = double(v[2]);
        return (x * Column{vx, vx, vx, vx} + y * Column{vy, vy, vy, vy}) + z * Column{vz, vz, vz, vz};
    };
    const Quad o = __builtin_convertvector(sum(ray.origin) + offset, Quad);
    const Quad d = __builtin_convertvector(sum(ray.direction), Quad);
    __builtin_memcpy(origin, &o, sizeof(o));
    __builtin_memcpy(direction, &d, sizeof(d));
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
