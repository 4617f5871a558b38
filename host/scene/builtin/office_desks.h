// The desks of the office with their chairs and all that lies on them.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host {

void furnishDesks(furniture::Interior& room);

}  // namespace host
