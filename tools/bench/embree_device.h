// embree_device.h - what the Embree contestants share. Private to embree_*.cpp.
#pragma once

#include "embree_side.h"
#include "figures.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <cstring>
#include <string>

namespace bench {

// A device that counts the bytes it keeps.
class EmbreeDevice {
  public:
    explicit EmbreeDevice(unsigned threads, const char* config = "")
        : device_(rtcNewDevice(("threads=" + std::to_string(threads) + "," + config).c_str())) {
        rtcSetDeviceMemoryMonitorFunction(
            device_,
            [](void* count, ssize_t bytes, bool) {
                static_cast<std::atomic<std::ptrdiff_t>*>(count)->fetch_add(bytes);
                return true;
            },
            &bytes_);
    }
    ~EmbreeDevice() { rtcReleaseDevice(device_); }
    EmbreeDevice(const EmbreeDevice&) = delete;
    EmbreeDevice& operator=(const EmbreeDevice&) = delete;

    [[nodiscard]] RTCDevice get() const { return device_; }
    [[nodiscard]] std::size_t byte_size() const { return static_cast<std::size_t>(bytes_.load()); }

  private:
    std::atomic<std::ptrdiff_t> bytes_{0};
    RTCDevice device_;
};

inline RTCBuildQuality embree_quality(EmbreeQuality quality) {
    switch (quality) {
        case EmbreeQuality::Low:
            return RTC_BUILD_QUALITY_LOW;
        case EmbreeQuality::Medium:
            return RTC_BUILD_QUALITY_MEDIUM;
        case EmbreeQuality::High:
            return RTC_BUILD_QUALITY_HIGH;
    }
    return RTC_BUILD_QUALITY_MEDIUM;
}

// A committed copy of the mesh; the caller releases it.
inline RTCGeometry new_embree_mesh(RTCDevice device, const BenchScene& source, RTCBuildQuality quality) {
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* p = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                      source.positions.size());
    std::memcpy(p, source.positions.data(), source.positions.size() * sizeof(glm::vec3));
    void* t = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3),
                                      source.triangles.size());
    std::memcpy(t, source.triangles.data(), source.triangles.size() * sizeof(glm::uvec3));
    rtcSetGeometryBuildQuality(mesh, quality);
    rtcCommitGeometry(mesh);
    return mesh;
}

template <class Work>
BuildTime time_of(Work&& work) {
    const double wall = clock_ms(), core = cpu_ms();
    work();
    return {clock_ms() - wall, cpu_ms() - core};
}

inline RTCRay embree_ray(const rc::Ray& ray) {
    return {ray.origin.x,
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
}

}  // namespace bench
