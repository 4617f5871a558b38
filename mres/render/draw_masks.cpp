#include "mres/render/draw_masks.h"

namespace mres {
namespace {

EdgeImages drawGeometryEdges(const PlannedFrame& planned, const params::FrameParams& params,
                             std::uint64_t frameId) {
  const MaskSettings& settings = planned.settings.mask;
  if (settings.minMaxMips) {
    planned.shared.minMax.draw(planned.context, settings, params, planned.plan);
    return {.geometry = &planned.shared.minMax.edges(0)};
  }
  const bool drawn = planned.shared.edges.draw(planned.context, settings, params, frameId);
  return {.geometry = &planned.shared.edges.edges(), .areShared = !drawn};
}

EdgeImages drawEdges(const PlannedFrame& planned, const params::FrameParams& params, std::uint64_t frameId) {
  EdgeImages edges;
  PreviewPass& preview = planned.passes.preview;
  if (!preview || planned.settings.mask.geometryAlways) edges = drawGeometryEdges(planned, params, frameId);
  if (!preview) return edges;
  preview.draw(planned.context, planned.refineThreshold(), params.size, edges.geometry);
  edges.effect = &preview.edges();
  return edges;
}

/// What only shows at the scale of a coarser level. Null: nothing, as in the paper.
const gl::Texture2D* drawEdgesOfLevel(const PlannedFrame& planned, std::size_t index) {
  const PlannedLevel& level = planned.level(index);
  if (planned.settings.mask.minMaxMips) return &planned.shared.minMax.edges(level.index);
  if (planned.isByMasks()) return nullptr;
  planned.shared.edges.drawFolds(planned.context, level.index, planned.level(index + 1).index,
                                 planned.level(0).size);
  return &planned.shared.edges.folds(level.index);
}

MaskSources maskSources(const PlannedFrame& planned, const EdgeImages& edges, const Frame& frame) {
  const MaskSettings& settings = planned.settings.mask;
  const auto combined = [&](int level, const gl::Texture2D& image) {
    if (frame.importance == 0) return &image;
    return &planned.shared.importance.draw(planned.context, settings.combination, level, image, frame);
  };
  MaskSources sources{.edges = combined(0, edges.effect != nullptr ? *edges.effect : *edges.geometry)};
  if (edges.geometry == nullptr) return sources;
  for (std::size_t i = 1; !planned.isCoarsest(i); ++i) {
    const int level = planned.level(i).index;
    if (const gl::Texture2D* image = drawEdgesOfLevel(planned, i))
      sources.joined.at(static_cast<std::size_t>(level)) = combined(level, *image);
  }
  return sources;
}

}  // namespace

EdgeImages drawMasks(const PlannedFrame& planned, const Frame& frame, const params::FrameParams& params) {
  const EdgeImages edges = drawEdges(planned, params, frame.id);
  planned.shared.masks.drawEdges(planned.context, maskSources(planned, edges, frame), planned.plan);
  if (planned.isByMasks()) planned.shared.masks.drawBlurred(planned.context, planned.plan);
  return edges;
}

}  // namespace mres
