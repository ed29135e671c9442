#include "embree_side.h"

#include "embree_device.h"

#include <algorithm>

namespace bench {

struct EmbreeSide::Impl {
    Impl(unsigned threads, const char* config) : device(threads, config) {}

    EmbreeDevice device;
    RTCScene scene = nullptr;
    BuildTime build_time;
};

EmbreeSide::EmbreeSide(const BenchScene& source, EmbreeMode mode, EmbreeQuality quality, unsigned threads,
                       const char* config)
    : impl_(std::make_unique<Impl>(threads, config)) {
    RTCDevice device = impl_->device.get();
    impl_->scene = rtcNewScene(device);
    rtcSetSceneFlags(impl_->scene, mode == EmbreeMode::Robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(impl_->scene, embree_quality(quality));
    RTCGeometry mesh = new_embree_mesh(device, source, embree_quality(quality));
    rtcAttachGeometry(impl_->scene, mesh);
    rtcReleaseGeometry(mesh);
    impl_->build_time = time_of([&] { rtcCommitScene(impl_->scene); });
}

EmbreeSide::~EmbreeSide() {
    rtcReleaseScene(impl_->scene);
}

BuildTime EmbreeSide::build_time() const {
    return impl_->build_time;
}

std::size_t EmbreeSide::byte_size() const {
    return impl_->device.byte_size();
}

namespace {

constexpr std::size_t kPacket = 16;

rc::Hit said_by(float t, float u, float v, unsigned geometry, unsigned primitive) {
    if (geometry == RTC_INVALID_GEOMETRY_ID) return {};
    return {.t = t, .u = u, .v = v, .primitive = primitive, .instance = 0};
}

template <class Say>
void closest_single(RTCScene scene, std::span<const rc::Ray> rays, Say&& say) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RTCRayHit query;
        query.ray = embree_ray(rays[i]);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &query);
        say(i, said_by(query.ray.tfar, query.hit.u, query.hit.v, query.hit.geomID, query.hit.primID));
    }
}

template <class Say>
void any_single(RTCScene scene, std::span<const rc::Ray> rays, Say&& say) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        RTCRay query = embree_ray(rays[i]);
        rtcOccluded1(scene, &context, &query);
        say(i, query.tfar < 0);
    }
}

template <class Say>
void packets(RTCScene scene, std::span<const rc::Ray> rays, bool any, Say&& say) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[kPacket];
    alignas(64) RTCRayHit16 packet;
    for (std::size_t begin = 0; begin < rays.size(); begin += kPacket) {
        const std::size_t n = std::min(kPacket, rays.size() - begin);
        for (std::size_t i = 0; i < kPacket; ++i) {
            const rc::Ray& ray = rays[begin + std::min(i, n - 1)];
            valid[i] = i < n ? -1 : 0;
            packet.ray.org_x[i] = ray.origin.x;
            packet.ray.org_y[i] = ray.origin.y;
            packet.ray.org_z[i] = ray.origin.z;
            packet.ray.tnear[i] = ray.t_min;
            packet.ray.dir_x[i] = ray.direction.x;
            packet.ray.dir_y[i] = ray.direction.y;
            packet.ray.dir_z[i] = ray.direction.z;
            packet.ray.time[i] = 0;
            packet.ray.tfar[i] = ray.t_max;
            packet.ray.mask[i] = 0xFFFFFFFFu;
            packet.ray.flags[i] = 0;
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        if (any) {
            rtcOccluded16(valid, scene, &context, reinterpret_cast<RTCRay16*>(&packet.ray));
        } else {
            rtcIntersect16(valid, scene, &context, &packet);
        }
        for (std::size_t i = 0; i < n; ++i) say(begin + i, packet, i);
    }
}

template <class Say>
void closest_packets(RTCScene scene, std::span<const rc::Ray> rays, Say&& say) {
    packets(scene, rays, false, [&](std::size_t at, const RTCRayHit16& packet, std::size_t i) {
        say(at, said_by(packet.ray.tfar[i], packet.hit.u[i], packet.hit.v[i], packet.hit.geomID[i],
                        packet.hit.primID[i]));
    });
}

template <class Say>
void any_packets(RTCScene scene, std::span<const rc::Ray> rays, Say&& say) {
    packets(scene, rays, true, [&](std::size_t at, const RTCRayHit16& packet, std::size_t i) {
        say(at, packet.ray.tfar[i] < 0);
    });
}

}  // namespace

Answer EmbreeSide::ask(std::span<const rc::Ray> rays, bool any, EmbreeCall call) const {
    Answer answer;
    const auto closest = [&](std::size_t, const rc::Hit& hit) { answer.add(!hit.is_miss(), hit.primitive); };
    const auto is_any = [&](std::size_t, bool is_hit) { answer.add(is_hit, 0); };
    if (call == EmbreeCall::Single) {
        any ? any_single(impl_->scene, rays, is_any) : closest_single(impl_->scene, rays, closest);
    } else {
        any ? any_packets(impl_->scene, rays, is_any) : closest_packets(impl_->scene, rays, closest);
    }
    return answer;
}

void EmbreeSide::closest(std::span<const rc::Ray> rays, EmbreeCall call, std::span<rc::Hit> hits) const {
    const auto say = [&](std::size_t i, const rc::Hit& hit) { hits[i] = hit; };
    call == EmbreeCall::Single ? closest_single(impl_->scene, rays, say)
                               : closest_packets(impl_->scene, rays, say);
}

void EmbreeSide::any(std::span<const rc::Ray> rays, EmbreeCall call, std::span<std::uint8_t> is_hit) const {
    const auto say = [&](std::size_t i, bool hit) { is_hit[i] = hit; };
    call == EmbreeCall::Single ? any_single(impl_->scene, rays, say) : any_packets(impl_->scene, rays, say);
}

}  // namespace bench
