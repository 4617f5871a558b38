#include "host/peers/level_picture.h"

#include "mres/level/level_targets.h"

namespace host {

void LevelPicture::draw(const PeerFrame& frame, const FilterPass& filter) {
  const glm::ivec2 size = frame.level(index_).size;
  const GLenum format = mres::levelFormat(frame.description());
  ensure(picture_, size, format, "mres.level");
  block_.bind(frame, index_);
  frame.drawEffect(picture_, index_);
  if (!frame.description().filtered) return;
  ensure(filteredAlongX_, size, format, "mres.filter");
  filter.alongX(frame, picture_.color(), filteredAlongX_);
  filter.alongY(frame, filteredAlongX_.color(), picture_);
}

}  // namespace host
