#include "box_tree.h"

#include <embree3/rtcore.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace foredraw {

namespace {

void set_bounds(const RTCBoundsFunctionArguments* arguments) {
  const Box<glm::vec3>& box = static_cast<const Box<glm::vec3>*>(arguments->geometryUserPtr)[arguments->primID];
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = box.min.x;
  bounds.lower_y = box.min.y;
  bounds.lower_z = box.min.z;
  bounds.upper_x = box.max.x;
  bounds.upper_y = box.max.y;
  bounds.upper_z = box.max.z;
}

}  // namespace

/// What goes through Embree with a ray.
struct EmbreeBoxTree::Query : RTCIntersectContext {
  Call call;
  std::exception_ptr failure;  ///< Embree's own functions are not made for exceptions

  /// Never says that the ray is blocked, so it goes on to the next box.
  static void met(const RTCOccludedFunctionNArguments* arguments) {
    Query& query = *static_cast<Query*>(arguments->context);
    if (query.failure) return;
    try {
      query.call.pass_on(query.call.call, arguments->primID);
    } catch (...) {
      query.failure = std::current_exception();
    }
  }
};

struct EmbreeBoxTree::Tree {
  // As many threads as there are: to limit them is to limit oneTBB's in the whole process.
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = nullptr;

  explicit Tree(std::span<const Box<glm::vec3>> boxes) {
    check();
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry, const_cast<Box<glm::vec3>*>(boxes.data()));  // read by set_bounds() alone
    rtcSetGeometryBoundsFunction(geometry, set_bounds, nullptr);
    rtcSetGeometryOccludedFunction(geometry, Query::met);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    check();
  }

  ~Tree() { release(); }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

 private:
  void check() {
    const RTCError error = rtcGetDeviceError(device);
    if (device != nullptr && error == RTC_ERROR_NONE) return;
    release();
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    throw std::runtime_error("Embree cannot build its tree: error " + std::to_string(error) +
                             (error == RTC_ERROR_UNSUPPORTED_CPU ? ", it does not support this processor" : "") +
                             "; measure with overdraw-raster");
  }

  void release() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

EmbreeBoxTree::EmbreeBoxTree(std::span<const Box<glm::vec3>> boxes) : tree_(std::make_shared<const Tree>(boxes)) {}

void EmbreeBoxTree::trace(const Ray& ray, const Call& call) const {
  Query query{{}, call, {}};
  rtcInitIntersectContext(&query);
  RTCRay traced{};
  traced.org_x = ray.from.x;
  traced.org_y = ray.from.y;
  traced.org_z = ray.from.z;
  traced.dir_x = ray.direction.x;
  traced.dir_y = ray.direction.y;
  traced.dir_z = ray.direction.z;
  traced.tfar = ray.length;
  traced.mask = ~0u;
  rtcOccluded1(tree_->scene, &query, &traced);
  if (query.failure) std::rethrow_exception(query.failure);
}

}  // namespace foredraw
