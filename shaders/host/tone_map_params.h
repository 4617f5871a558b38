#pragma once
#include "common/params.h"

BEGIN_PARAMS
UNIFORM_BLOCK(ToneMapParams) {
  float exposure;  // factor on radiance
  float toneMapPadding0;
  float toneMapPadding1;
  float toneMapPadding2;
};
END_PARAMS
