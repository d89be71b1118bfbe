#include "core/io/gltf_scene.h"

#include <cmath>
#include <numeric>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "core/base/text.h"

namespace aomd::io::detail {
namespace {

class Scene {
 public:
  explicit Scene(const GltfFile& file) : file_(file), seen_(file.model().nodes.size(), false) {}

  std::vector<GltfInstance> instances() {
    for (const int root : roots()) visit(root);
    return std::move(found_);
  }

 private:
  struct Placed {
    int node;
    glm::dmat4 place;
  };

  std::vector<int> roots() {
    const tinygltf::Model& model = file_.model();
    if (model.scenes.empty()) return nodes_without_parent();
    const int scene = model.defaultScene < 0 ? 0 : model.defaultScene;
    if (static_cast<std::size_t>(scene) >= model.scenes.size())
      file_.source().fail("there is no scene " + std::to_string(scene));
    return model.scenes[static_cast<std::size_t>(scene)].nodes;
  }

  std::vector<int> nodes_without_parent() const {
    const auto& nodes = file_.model().nodes;
    std::vector<bool> child(nodes.size(), false);
    for (const tinygltf::Node& node : nodes)
      for (const int c : node.children)
        if (c >= 0 && static_cast<std::size_t>(c) < nodes.size())
          child[static_cast<std::size_t>(c)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!child[i]) roots.push_back(static_cast<int>(i));
    return roots;
  }

  void visit(int root) {
    std::vector<Placed> open{{root, glm::dmat4(1)}};
    while (!open.empty()) {
      const Placed at = open.back();
      open.pop_back();
      const tinygltf::Node& node = enter(at.node);
      const glm::dmat4 place = at.place * place_of(node, at.node);
      if (node.mesh >= 0) add(node, place);
      for (std::size_t k = node.children.size(); k > 0; --k)
        open.push_back({node.children[k - 1], place});
    }
  }

  const tinygltf::Node& enter(int index) {
    const std::string what = "node " + std::to_string(index);
    if (index < 0 || static_cast<std::size_t>(index) >= seen_.size())
      file_.source().fail("there is no " + what);
    const auto i = static_cast<std::size_t>(index);
    if (seen_[i]) file_.source().fail(what + " has two parents, or is part of a circle");
    seen_[i] = true;
    return file_.model().nodes[i];
  }

  glm::dmat4 place_of(const tinygltf::Node& node, int index) const {
    const auto numbers = [&](const std::vector<double>& given, std::size_t n) {
      const bool sound = given.size() == n && std::all_of(given.begin(), given.end(), [](double x) {
                           return std::isfinite(x);
                         });
      if (!given.empty() && !sound)
        file_.source().fail("node " + std::to_string(index) + " is placed by other than " +
                            counted(n, "number"));
      return sound;
    };
    if (numbers(node.matrix, 16)) return glm::make_mat4(node.matrix.data());
    glm::dmat4 place(1);
    if (numbers(node.translation, 3))
      place = glm::translate(place, glm::make_vec3(node.translation.data()));
    if (numbers(node.rotation, 4)) {
      const double* const q = node.rotation.data();
      place *= glm::mat4_cast(glm::normalize(glm::dquat(q[3], q[0], q[1], q[2])));
    }
    if (numbers(node.scale, 3)) place = glm::scale(place, glm::make_vec3(node.scale.data()));
    return place;
  }

  void add(const tinygltf::Node& node, const glm::dmat4& place) {
    const auto& meshes = file_.model().meshes;
    if (static_cast<std::size_t>(node.mesh) >= meshes.size())
      file_.source().fail("there is no mesh " + std::to_string(node.mesh));
    const std::string& name = meshes[static_cast<std::size_t>(node.mesh)].name;
    found_.push_back({node.mesh, place, node.name.empty() ? name : node.name});
  }

  const GltfFile& file_;
  std::vector<bool> seen_;
  std::vector<GltfInstance> found_;
};

}  // namespace

std::vector<GltfInstance> scene_of(const GltfFile& file) {
  const auto& model = file.model();
  if (!model.nodes.empty() || !model.scenes.empty()) return Scene(file).instances();
  std::vector<GltfInstance> all;
  for (std::size_t i = 0; i < model.meshes.size(); ++i)
    all.push_back({static_cast<int>(i), glm::dmat4(1), model.meshes[i].name});
  return all;
}

}  // namespace aomd::io::detail
