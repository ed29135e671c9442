#include "raycore/scene.h"

#include "binned_builder.h"
#include "collapse.h"
#include "contract.h"
#include "data.h"
#include "placement.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rc {

namespace {

BuildRef ref_of(const Box& box, std::uint32_t id) {
    BuildRef ref{};
    for (std::size_t a = 0; a < 3; ++a) {
        ref.neg_min[a] = -box.min[a];
        ref.max[a] = box.max[a];
    }
    ref.item = id;
    return ref;
}

// Every instance that can be met: its view filled and its box in the world.
std::vector<BuildRef> place_instances(Scene::Data& scene) {
    std::vector<BuildRef> refs;
    refs.reserve(scene.instances.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const std::optional<Placement> placement = place(instance);
        if (!placement) {
            ++scene.dropped;
            continue;
        }
        kernel::InstanceView& view = scene.views[i];
        for (std::size_t c = 0; c < 4; ++c) {
            for (std::size_t r = 0; r < 3; ++r)
                view.local_from_world[c][r] = placement->local_from_world[4 * r + c];
            view.local_from_world[c][3] = 0.0;
        }
        view.blas = instance.blas->data().view();
        view.layers = instance.layers;
        view.is_identity = instance.world_from_instance == glm::mat4x3(1.0f);
        scene.view.condition = std::max(scene.view.condition, placement->condition);
        refs.push_back(ref_of(placement->world_box, static_cast<std::uint32_t>(i)));
    }
    return refs;
}

}  // namespace

Scene::Scene(std::unique_ptr<Data> data) : data_(std::move(data)) {}
Scene::~Scene() = default;

std::size_t Scene::instance_count() const {
    return data_->instances.size();
}
std::size_t Scene::dropped_instances() const {
    return data_->dropped;
}
Box Scene::bounds() const {
    return data_->bounds;
}

const Instance& Scene::instance(std::uint32_t id) const {
    RC_EXPECTS(id < data_->instances.size(), "an instance id that SceneBuilder::add returned");
    return data_->instances[id];
}

std::uint32_t SceneBuilder::add(Instance instance) {
    instances_.push_back(std::move(instance));
    return static_cast<std::uint32_t>(instances_.size() - 1);
}

void SceneBuilder::set_transform(std::uint32_t id, const glm::mat4x3& world_from_instance) {
    RC_EXPECTS(id < instances_.size(), "an instance id that SceneBuilder::add returned");
    instances_[id].world_from_instance = world_from_instance;
}

void SceneBuilder::set_blas(std::uint32_t id, std::shared_ptr<const Blas> blas) {
    RC_EXPECTS(id < instances_.size(), "an instance id that SceneBuilder::add returned");
    instances_[id].blas = std::move(blas);
}

void SceneBuilder::set_layers(std::uint32_t id, LayerMask layers) {
    RC_EXPECTS(id < instances_.size(), "an instance id that SceneBuilder::add returned");
    instances_[id].layers = layers;
}

std::shared_ptr<const Scene> SceneBuilder::commit() const {
    auto scene = std::make_unique<Scene::Data>();
    scene->instances = instances_;
    scene->views.resize(instances_.size());
    scene->bounds = {glm::vec3(kInfinity), glm::vec3(-kInfinity)};

    std::vector<BuildRef> refs = place_instances(*scene);
    if (!refs.empty()) {
        const BinaryTree binary = build_binary_tree(refs, SplitCosts{.max_leaf = 1});
        std::vector<std::uint32_t> layers(instances_.size());
        for (std::size_t i = 0; i < layers.size(); ++i) layers[i] = instances_[i].layers;
        WideTree tree = collapse_tlas(binary, layers);
        scene->nodes = std::move(tree.nodes);
        scene->view.root = tree.root;
        for (std::size_t a = 0; a < 3; ++a) {
            scene->view.min[a] = scene->bounds.min[a] = binary.nodes[0].min[a];
            scene->view.max[a] = scene->bounds.max[a] = binary.nodes[0].max[a];
        }
    }
    scene->view.nodes = scene->nodes.data();
    scene->view.instances = scene->views.data();
    return std::make_shared<const Scene>(std::move(scene));
}

}  // namespace rc
