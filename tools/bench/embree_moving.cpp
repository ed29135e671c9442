// Embree's moving scenes: a mesh that bends, and instances that walk.
#include "embree_device.h"

namespace bench {

struct EmbreeCloth::Impl {
    explicit Impl(unsigned threads) : device(threads) {}

    EmbreeDevice device;
    RTCScene scene = nullptr;
    RTCGeometry mesh = nullptr;
};

EmbreeCloth::EmbreeCloth(const BenchScene& source, unsigned threads)
    : impl_(std::make_unique<Impl>(threads)) {
    impl_->scene = rtcNewScene(impl_->device.get());
    rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(impl_->scene, RTC_BUILD_QUALITY_LOW);
    impl_->mesh = new_embree_mesh(impl_->device.get(), source, RTC_BUILD_QUALITY_REFIT);
    rtcAttachGeometry(impl_->scene, impl_->mesh);
    rtcCommitScene(impl_->scene);
}

EmbreeCloth::~EmbreeCloth() {
    rtcReleaseGeometry(impl_->mesh);
    rtcReleaseScene(impl_->scene);
}

BuildTime EmbreeCloth::move(std::span<const glm::vec3> positions) {
    void* p = rtcGetGeometryBufferData(impl_->mesh, RTC_BUFFER_TYPE_VERTEX, 0);
    std::memcpy(p, positions.data(), positions.size_bytes());
    return time_of([&] {
        rtcUpdateGeometryBuffer(impl_->mesh, RTC_BUFFER_TYPE_VERTEX, 0);
        rtcCommitGeometry(impl_->mesh);
        rtcCommitScene(impl_->scene);
    });
}

struct EmbreeCrowd::Impl {
    explicit Impl(unsigned threads) : device(threads) {}

    EmbreeDevice device;
    RTCScene body = nullptr;
    RTCScene scene = nullptr;
    std::vector<RTCGeometry> instances;
};

EmbreeCrowd::EmbreeCrowd(const BenchScene& source, std::span<const glm::mat4x3> places, EmbreeQuality quality,
                         unsigned threads)
    : impl_(std::make_unique<Impl>(threads)) {
    RTCDevice device = impl_->device.get();
    impl_->body = rtcNewScene(device);
    RTCGeometry mesh = new_embree_mesh(device, source, RTC_BUILD_QUALITY_MEDIUM);
    rtcAttachGeometry(impl_->body, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(impl_->body);
    impl_->scene = rtcNewScene(device);
    rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(impl_->scene, embree_quality(quality));
    for (std::size_t i = 0; i < places.size(); ++i) {
        RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(instance, impl_->body);
        rtcAttachGeometryByID(impl_->scene, instance, static_cast<unsigned>(i));
        impl_->instances.push_back(instance);
    }
    move(places);
}

EmbreeCrowd::~EmbreeCrowd() {
    for (RTCGeometry instance : impl_->instances) rtcReleaseGeometry(instance);
    rtcReleaseScene(impl_->scene);
    rtcReleaseScene(impl_->body);
}

BuildTime EmbreeCrowd::move(std::span<const glm::mat4x3> places) {
    return time_of([&] {
        for (std::size_t i = 0; i < places.size(); ++i) {
            rtcSetGeometryTransform(impl_->instances[i], 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                                    &places[i][0][0]);
            rtcCommitGeometry(impl_->instances[i]);
        }
        rtcCommitScene(impl_->scene);
    });
}

namespace {

Answer ask_scene(RTCScene scene, std::span<const rc::Ray> rays, bool any) {
    Answer answer;
    RTCIntersectContext context;
    for (const rc::Ray& ray : rays) {
        rtcInitIntersectContext(&context);
        RTCRayHit query;
        query.ray = embree_ray(ray);
        if (any) {
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

}  // namespace

Answer EmbreeCrowd::ask(std::span<const rc::Ray> rays, bool any) const {
    return ask_scene(impl_->scene, rays, any);
}

struct EmbreePlaced::Impl {
    explicit Impl(unsigned threads) : device(threads) {}

    EmbreeDevice device;
    std::vector<RTCScene> meshes;
    RTCScene scene = nullptr;
};

EmbreePlaced::EmbreePlaced(std::span<const BenchScene> meshes, std::span<const Placed> instances,
                           unsigned threads)
    : impl_(std::make_unique<Impl>(threads)) {
    RTCDevice device = impl_->device.get();
    for (const BenchScene& source : meshes) {
        impl_->meshes.push_back(rtcNewScene(device));
        rtcSetSceneBuildQuality(impl_->meshes.back(), RTC_BUILD_QUALITY_HIGH);
        RTCGeometry mesh = new_embree_mesh(device, source, RTC_BUILD_QUALITY_HIGH);
        rtcAttachGeometry(impl_->meshes.back(), mesh);
        rtcReleaseGeometry(mesh);
        rtcCommitScene(impl_->meshes.back());
    }
    impl_->scene = rtcNewScene(device);
    for (const Placed& placed : instances) {
        RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(instance, impl_->meshes[placed.mesh]);
        rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                                &placed.world_from_instance[0][0]);
        rtcCommitGeometry(instance);
        rtcAttachGeometry(impl_->scene, instance);
        rtcReleaseGeometry(instance);
    }
    rtcCommitScene(impl_->scene);
}

EmbreePlaced::~EmbreePlaced() {
    rtcReleaseScene(impl_->scene);
    for (RTCScene mesh : impl_->meshes) rtcReleaseScene(mesh);
}

Answer EmbreePlaced::ask(std::span<const rc::Ray> rays, bool any) const {
    return ask_scene(impl_->scene, rays, any);
}

}  // namespace bench
