// The host's scene: plain data, independent of where it came from (glTF or code) and of OpenGL.
//
// Conventions: right-handed, +Y up, metres; a camera looks along its own -Z. Colours are linear RGB unless an
// Image says sRGB. Texture coordinates follow glTF: (0, 0) is the upper-left corner of the image, whose rows
// are stored top to bottom.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

namespace host {

struct Vertex {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f, 1.0f, 0.0f};         ///< unit length
  glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};  ///< xyz unit length, w = handedness (+1 or -1), as in glTF
  glm::vec2 uv{0.0f};
};

/// Indexed triangles, counter-clockwise seen from the front, one material.
struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< a multiple of three, each below vertices.size()
  int material = -1;                   ///< index into Scene::materials; -1 is the default material
};

/// Eight-bit RGBA pixels.
struct Image {
  std::string name;
  glm::ivec2 size{0};
  std::vector<std::uint8_t> pixels;  ///< size.x * size.y * 4 bytes
};

enum class Wrap { repeat, mirroredRepeat, clampToEdge };

struct Texture {
  int image = -1;
  Wrap wrapS = Wrap::repeat;
  Wrap wrapT = Wrap::repeat;
  bool nearest = false;  ///< magnify and minify without interpolation
};

enum class AlphaMode { opaque, mask, blend };

/// A texture as a material uses it, with KHR_texture_transform folded into one affine map.
struct TextureUse {
  int texture = -1;  ///< index into Scene::textures; -1 is none
  glm::mat3 uvTransform{1.0f};
};

/// glTF's metallic-roughness material.
struct Material {
  std::string name;
  glm::vec4 baseColor{1.0f};
  float metallic = 1.0f;     ///< 0..1
  float roughness = 1.0f;    ///< 0..1, perceptual
  glm::vec3 emissive{0.0f};  ///< linear radiance, may exceed 1
  float normalScale = 1.0f;
  TextureUse baseColorTexture;          ///< sRGB, alpha in A
  TextureUse metallicRoughnessTexture;  ///< linear, roughness in G, metallic in B
  TextureUse normalTexture;             ///< linear, tangent space
  TextureUse emissiveTexture;           ///< sRGB
  AlphaMode alphaMode = AlphaMode::opaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
};

/// A mesh placed in the world. Negative determinants (mirrored) are allowed.
struct Instance {
  int mesh = 0;
  glm::mat4 transform{1.0f};
};

enum class LightType { directional, point, spot };

/// As in KHR_lights_punctual.
struct Light {
  std::string name;
  LightType type = LightType::directional;
  glm::vec3 color{1.0f};
  float intensity = 1.0f;                  ///< lux for directional lights, candela for the others
  float range = 0.0f;                      ///< metres; 0 is unlimited
  glm::vec3 position{0.0f};                ///< unused by directional lights
  glm::vec3 direction{0.0f, -1.0f, 0.0f};  ///< the way the light travels; unused by point lights
  float innerConeAngle = 0.0f;             ///< radians, from the axis
  float outerConeAngle = 0.7853982f;
};

struct Camera {
  std::string name;
  glm::vec3 position{0.0f};
  glm::quat orientation{1.0f, 0.0f, 0.0f, 0.0f};  ///< camera to world
  float verticalFov = 0.9f;                       ///< radians; used by perspective cameras
  float nearPlane = 0.05f;                        ///< metres
  float farPlane = 200.0f;                        ///< metres; 0 is infinitely far
  std::optional<float> orthographicHeight;        ///< metres, bottom to top; set for orthographic cameras
};

/// What the sky and everything outside of the scene sends in: a gradient over the vertical direction.
struct Sky {
  glm::vec3 zenith{0.25f, 0.45f, 0.85f};
  glm::vec3 horizon{0.75f, 0.85f, 0.95f};
  glm::vec3 ground{0.25f, 0.23f, 0.2f};
  float intensity = 1.0f;
};

struct Bounds {
  glm::vec3 min{0.0f};
  glm::vec3 max{0.0f};
};

struct Scene {
  std::string name;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Image> images;
  std::vector<Texture> textures;
  std::vector<Instance> instances;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  Sky sky;
  glm::vec3 ambient{0.3f};  ///< constant ambient radiance inside the scene, dimmed by ambient occlusion
  std::vector<std::string> warnings;  ///< what a file's loader had to leave out or guess, a sentence each
};

/// Triangles drawn: those of each mesh times its instances.
std::size_t triangleCount(const Scene& scene);

/// World-space bounds of all instances; a unit cube for an empty scene.
Bounds boundsOf(const Scene& scene);

/// A camera at `position` that looks at `target` with +Y up.
Camera lookAt(std::string name, glm::vec3 position, glm::vec3 target, float verticalFovDegrees);

/// World to view.
glm::mat4 viewMatrix(const Camera& camera);

/// View to clip, with OpenGL's clip range -1..1.
glm::mat4 projectionMatrix(const Camera& camera, float aspect);

/// The scene of a built-in name (`office`, `hall`, `breakfast`) or of a .gltf or .glb file, with at least one
/// camera: those of the file beside it (camera_file.h), of the file itself, or found automatically. Throws
/// std::runtime_error with a sentence that says what is wrong and what to do.
Scene loadScene(const std::string& nameOrPath);

/// The built-in names, in the order in which they are listed to users.
const std::vector<std::string>& builtinSceneNames();

}  // namespace host
