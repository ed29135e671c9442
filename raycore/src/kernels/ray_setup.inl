// kernels/ray_setup.inl - a ray made ready for triangles (sheared) and for boxes (slopes and padding).
//
// Padding. A triangle is hit when its rounded, sheared corners hold the ray's axis (triangle.inl), so the true
// point P of the triangle may lie off the true ray, by at most
//     e (5 |S_x| s + 6 E)  on axis x,  e = 2^-24, s its distance along the ray's axis, E the triangle's largest extent,
// and the slab arithmetic errs by at most e (4 |o| + 5 |S_x| s). What grows with E is in the boxes (kSlack); what grows
// with s moves planes by a share of their distance, what grows with o by a constant. Neither costs anything in the walk:
// near and far planes merely have different factors and constants. README.md has the proof line by line.
//
// It is worth being sharp: rays that start on a surface stand 28 e |o| off it, and boxes padded by more than that, say
// by shares of the whole tree's size, make every one of them look into its own leaf again.

namespace rc::kernel::RC_ISA {
namespace {

// Three axes and a lane that means nothing; the compiler's own vectors, since every ISA has four floats.
typedef float Quad __attribute__((vector_size(16)));
typedef std::int32_t QuadBits __attribute__((vector_size(16)));

// Component by component: a caller has just written them so, and a processor that reads what several stores wrote waits.
static inline Quad load_quad(const float* p) {
    return Quad{p[0], p[1], p[2], 0.0f};
}
static inline Quad quad_of(float a) {
    return Quad{a, a, a, a};
}
static inline Quad quad_max(Quad a, Quad b) {
    return a > b ? a : b;
}
static inline Quad quad_min(Quad a, Quad b) {
    return a < b ? a : b;
}
// The largest of three, in every lane that means something: nobody waits until one number is spread again.
static inline Quad largest(Quad a) {
    const Quad next = __builtin_shufflevector(a, a, 1, 2, 0, 3),
               last = __builtin_shufflevector(a, a, 2, 0, 1, 3);
    return quad_max(quad_max(a, next), last);
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

// Bit i: whether lane i of three is negative.
static inline std::uint32_t sign_bits(QuadBits a) {
#ifdef __SSE2__
    return std::uint32_t(__builtin_ia32_movmskps(with_bits(a))) & 7u;
#else
    return (std::uint32_t(a[0]) >> 31) | (std::uint32_t(a[1]) >> 31 << 1) | (std::uint32_t(a[2]) >> 31 << 2);
#endif
}
static inline std::uint32_t sign_bits(Quad a) {
    return sign_bits(reinterpret_cast<QuadBits>(a));
}
// The bits of a's magnitude, which order as the magnitudes do.
static inline QuadBits magnitude_bits(Quad a) {
    return reinterpret_cast<QuadBits>(absolute(a));
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

// By which of three sizes is the largest: bit 0 says x > y, bit 1 y > z, bit 2 x > z. Of equals it is the last.
struct Axes {
    int x, y, z;
};
inline constexpr Axes kAlongX{1, 2, 0}, kAlongY{2, 0, 1}, kAlongZ{0, 1, 2};
inline constexpr Axes kAxes[8] = {kAlongZ, kAlongZ, kAlongY, kAlongZ, kAlongZ, kAlongX, kAlongY, kAlongX};

// Axes in the order of a ray that runs mostly along kz.
inline constexpr int kNextAxis[3] = {1, 2, 0};

inline constexpr float kLargest = 0x1.fffffep127f;  // t beyond it, either way, is infinite: a miss

static inline float finite_limit(float t_max) {
    return t_max < kLargest ? t_max : kLargest;
}
static inline float finite_start(float t_min) {
    return t_min > -kLargest ? t_min : -kLargest;
}

// Where a ray starts and goes, in some frame.
struct Way {
    Quad origin, direction;
};
static inline Way way_of(const RayIn& ray) {
    return {load_quad(ray.origin), load_quad(ray.direction)};
}

// All three components of both finite, and not all of the direction's zero.
static inline bool is_way(const Way& way) {
    constexpr std::int32_t kInfinite = 0x7F800000;
    const QuadBits o = magnitude_bits(way.origin), d = magnitude_bits(way.direction);
    const bool is_finite = sign_bits((o - kInfinite) & (d - kInfinite)) == 7u;
    return is_finite & (sign_bits(0 - d) != 0);
}

static inline bool is_good(const RayIn& ray) {
    return is_way(way_of(ray)) & (ray.t_min <= ray.t_max);
}

// `way` is one; its components lie in memory as well.
static inline void shear(const Way& way, const float* origin, const float* direction, LocalRay& ray) {
    ray.origin = way.origin;
    ray.direction = way.direction;
    const Quad size = absolute(ray.direction);
    // Looked up: which axis it is can not be guessed. A difference of floats is negative just where the first is less.
    const Quad lesser{size[1], size[2], size[2], 0.0f}, greater{size[0], size[1], size[0], 0.0f};
    const Axes& axes = kAxes[sign_bits(lesser - greater)];
    ray.kz = axes.z;
    ray.kx = axes.x;
    ray.ky = axes.y;
    ray.dz_abs = largest(size)[0];
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

// The farthest the tree's bounds lie from the origin along each axis, and along any: so nobody waits for the ray's own.
static inline Quad reaches(const TreeBounds& tree, const LocalRay& ray) {
    return quad_max(absolute(load_quad(tree.min) - ray.origin), absolute(load_quad(tree.max) - ray.origin));
}

// For boxes without slack around them, and for rays that may meet something behind their origin: by what the bounds'
// farthest points may err. A slope below 2^-40 strays from the true ray by less than the term with 2^-39.
static inline Padding wide_padding(const LocalRay& ray, const TreeBounds& tree, float extra_pad) {
    const Quad reach = reaches(tree, ray);
    const Quad reach_z = largest(reach);
    const Quad across = (absolute(ray.origin) + reach) * quad_of(0x1p-21f) + quad_of(extra_pad + kLeastPad);
    return {across + reach_z * quad_of(0x1p-21f + 0x1p-39f), reach_z[0] * 0x1p-21f + kLeastPad, 0.0f};
}

// For boxes with their triangles' slack around them: no more than a point's own way from the origin.
static inline Padding sharp_padding(const LocalRay& ray, const TreeBounds& tree) {
    const Quad across = absolute(ray.origin) * quad_of(0x1p-21f) + quad_of(kLeastPad);
    return {across + largest(reaches(tree, ray)) * quad_of(0x1p-39f), kLeastPad, 0x1p-20f};
}

// Below 2^-80 or above 2^80, asked at once: one over such a length, or over its shares, may overflow or vanish.
static inline bool is_extreme(float length) {
    constexpr std::uint32_t kLeast = 47u << 23, kMost = 207u << 23;  // as bits
    std::uint32_t bits;
    __builtin_memcpy(&bits, &length, sizeof(bits));
    return bits - kLeast > kMost - kLeast;
}

static inline void aim(const LocalRay& ray, const Padding& padding, float t_min, float t_max, BoxRay& box) {
    const QuadBits sign = sign_of(ray.direction);
    const Quad size = absolute(ray.direction), length = largest(size), one = quad_of(1.0f);
    // Divided before it is known by how much: nobody waits for the two in turn.
    Quad per_unit = length * (one / size);
    if (__builtin_expect(is_extreme(ray.dz_abs), 0)) per_unit = one / (size / length);
    const Quad rcp = with_sign(quad_min(per_unit, quad_of(0x1p40f)), sign);
    const Quad towards = with_sign(padding.pad, sign);
    box.near_rcp = rcp * quad_of(1.0f - padding.spread);
    box.far_rcp = rcp * quad_of(1.0f + padding.spread);
    box.near_at_zero = -(ray.origin + towards) * box.near_rcp;
    box.far_at_zero = -(ray.origin - towards) * box.far_rcp;
    box.octant = &kOctants.of[sign_bits(sign)];

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
static inline Way to_local(const double (&m)[4][4], const RayIn& ray) {
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
    return {__builtin_convertvector(sum(ray.origin) + offset, Quad),
            __builtin_convertvector(sum(ray.direction), Quad)};
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
