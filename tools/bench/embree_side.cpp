#include "embree_side.h"

#include <embree3/rtcore.h>

#include <chrono>
#include <cstring>
#include <string>

namespace bench {

struct EmbreeSide::Impl {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    double build_ms = 0;
};

EmbreeSide::EmbreeSide(const BenchScene& source, EmbreeMode mode, bool high_quality, unsigned threads)
    : impl_(std::make_unique<Impl>()) {
    const std::string config = "threads=" + std::to_string(threads);
    impl_->device = rtcNewDevice(config.c_str());
    impl_->scene = rtcNewScene(impl_->device);
    rtcSetSceneFlags(impl_->scene, mode == EmbreeMode::Robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(impl_->scene, high_quality ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry mesh = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* p = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                      source.positions.size());
    std::memcpy(p, source.positions.data(), source.positions.size() * sizeof(glm::vec3));
    void* t = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3),
                                      source.triangles.size());
    std::memcpy(t, source.triangles.data(), source.triangles.size() * sizeof(glm::uvec3));
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(impl_->scene, mesh);
    rtcReleaseGeometry(mesh);
    const auto start = std::chrono::steady_clock::now();
    rtcCommitScene(impl_->scene);
    impl_->build_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

EmbreeSide::~EmbreeSide() {
    rtcReleaseScene(impl_->scene);
    rtcReleaseDevice(impl_->device);
}

double EmbreeSide::build_ms() const {
    return impl_->build_ms;
}

namespace {

Answer ask_single(RTCScene scene, const RaySet& set) {
    Answer answer;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (const rc::Ray& ray : set.rays) {
        RTCRayHit query;
        query.ray = {ray.origin.x,
                     ray.origin.y,
                     ray.origin.z,
                     ray.t_min,
                     ray.direction.x,
                     ray.direction.y,
                     ray.direction.z,
                     0,
                     ray.t_max,
                     0xFFFFFFFFu,
                     0,
                     0};
        if (set.any) {
            rtcOccluded1(scene, &context, &query.ray);
            answer.add(query.ray.tfar < 0, 0);
        } else {
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene, &context, &query);
            answer.add(query.hit.geomID != RTC_INVALID_GEOMETRY_ID, query.hit.primID);
        }
    }
    return answer;
}

Answer ask_packets(RTCScene scene, const RaySet& set) {
    Answer answer;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[16];
    alignas(64) RTCRayHit16 packet;
    for (std::size_t begin = 0; begin < set.rays.size(); begin += 16) {
        const std::size_t n = std::min<std::size_t>(16, set.rays.size() - begin);
        for (std::size_t i = 0; i < 16; ++i) {
            const rc::Ray& ray = set.rays[begin + std::min(i, n - 1)];
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
        if (set.any) {
            rtcOccluded16(valid, scene, &context, reinterpret_cast<RTCRay16*>(&packet.ray));
            for (std::size_t i = 0; i < n; ++i) answer.add(packet.ray.tfar[i] < 0, 0);
        } else {
            rtcIntersect16(valid, scene, &context, &packet);
            for (std::size_t i = 0; i < n; ++i)
                answer.add(packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID, packet.hit.primID[i]);
        }
    }
    return answer;
}

}  // namespace

Answer EmbreeSide::ask(const RaySet& set, EmbreeCall call) const {
    return call == EmbreeCall::Single ? ask_single(impl_->scene, set) : ask_packets(impl_->scene, set);
}

}  // namespace bench
