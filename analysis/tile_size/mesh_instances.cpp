// SPDX-License-Identifier: MIT
// Nodes of a scene -> the transforms of their meshes; see mesh_instances.h.
// Source: glTF 2.0 specification, sections 3.5 and 3.7.3.
#include "mesh_instances.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace lichen {
namespace {

using nlohmann::json;

/// The element of an array of the root, or null.
const json* element(const json& root, const char* array, std::size_t index) {
  const auto list = root.find(array);
  return list != root.end() && list->is_array() && index < list->size() ? &(*list)[index] : nullptr;
}

std::optional<std::size_t> indexOf(const json& object, const char* key) {
  const auto value = object.is_object() ? object.find(key) : object.end();
  return value != object.end() && value->is_number_unsigned()
             ? std::optional(value->get<std::size_t>())
             : std::nullopt;
}

/// The indices in an array of an object; empty if absent.
std::vector<std::size_t> indicesOf(const json& object, const char* key) {
  std::vector<std::size_t> indices;
  const auto list = object.is_object() ? object.find(key) : object.end();
  if (list != object.end() && list->is_array())
    for (const json& each : *list)
      if (each.is_number_unsigned())
        indices.push_back(each.get<std::size_t>());
  return indices;
}

/// Numbers of a node; `absent` if it does not have as many.
std::vector<double> numbersOf(const json& node, const char* key, std::vector<double> absent) {
  const auto list = node.find(key);
  if (list == node.end() || !list->is_array() || list->size() != absent.size() ||
      !std::all_of(list->begin(), list->end(), [](const json& each) { return each.is_number(); }))
    return absent;
  return list->get<std::vector<double>>();
}

Eigen::Affine3d localTransform(const json& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node.contains("matrix")) {
    const std::vector<double> m =
        numbersOf(node, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
    return transform;
  }
  const std::vector<double> t = numbersOf(node, "translation", {0, 0, 0});
  const std::vector<double> q = numbersOf(node, "rotation", {0, 0, 0, 1}); // x, y, z, w
  const std::vector<double> s = numbersOf(node, "scale", {1, 1, 1});
  transform.translate(Eigen::Vector3d(t[0], t[1], t[2]));
  transform.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
  transform.scale(Eigen::Vector3d(s[0], s[1], s[2]));
  return transform;
}

/// The world transform of each node of the default scene.
std::vector<std::optional<Eigen::Affine3d>> worldTransforms(const json& root) {
  std::vector<std::optional<Eigen::Affine3d>> worlds;
  const auto nodes = root.find("nodes");
  const json* scene = element(root, "scenes", indexOf(root, "scene").value_or(0));
  if (nodes == root.end() || !nodes->is_array() || scene == nullptr)
    return worlds;
  worlds.resize(nodes->size());
  std::vector<std::pair<std::size_t, Eigen::Affine3d>> pending; // a node and its parent's transform
  const auto push = [&](const json& object, const char* key, const Eigen::Affine3d& parent) {
    for (const std::size_t child : indicesOf(object, key))
      pending.emplace_back(child, parent);
  };
  push(*scene, "nodes", Eigen::Affine3d::Identity());
  while (!pending.empty()) {
    const auto [index, parent] = pending.back();
    pending.pop_back();
    if (index >= worlds.size() || worlds[index] || !(*nodes)[index].is_object())
      continue;
    worlds[index] = parent * localTransform((*nodes)[index]);
    push((*nodes)[index], "children", *worlds[index]);
  }
  return worlds;
}

/// The transform that the first joint of a skin gives to its mesh, which ignores its own node's.
Eigen::Affine3d skinTransform(GltfScene& scene, const json& skin,
                              const std::vector<std::optional<Eigen::Affine3d>>& worlds) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  const std::vector<std::size_t> joints = indicesOf(skin, "joints");
  if (!joints.empty() && joints.front() < worlds.size() && worlds[joints.front()])
    transform = *worlds[joints.front()];
  if (const auto accessor = indexOf(skin, "inverseBindMatrices"))
    if (const auto matrices = scene.matrices(*accessor); matrices && !matrices.value().empty()) {
      const Eigen::Matrix4f inverseBind =
          Eigen::Map<const Eigen::Matrix4f>(matrices.value().front().data());
      transform.matrix() *= inverseBind.cast<double>();
    }
  return transform;
}

} // namespace

std::vector<MeshInstance> meshInstances(GltfScene& scene) {
  const json& root = scene.document();
  const std::vector<std::optional<Eigen::Affine3d>> worlds = worldTransforms(root);
  std::vector<MeshInstance> instances;
  for (std::size_t node = 0; node < worlds.size(); ++node) {
    const auto mesh = worlds[node] ? indexOf(root["nodes"][node], "mesh") : std::nullopt;
    if (!mesh)
      continue;
    const auto skinIndex = indexOf(root["nodes"][node], "skin");
    const json* skin = skinIndex ? element(root, "skins", *skinIndex) : nullptr;
    instances.push_back(
        {node, *mesh, skin != nullptr ? skinTransform(scene, *skin, worlds) : *worlds[node]});
  }
  return instances;
}

} // namespace lichen
