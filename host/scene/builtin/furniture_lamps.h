// Lamps. Desk lamps stand on y = 0; what hangs, hangs from y = 0 downwards.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host::furniture {

/// A jointed lamp whose head looks along +Z and down.
Piece deskLamp();

/// A suspended linear office luminaire, `length` long along x.
Piece linearLuminaire(float length, float drop);

/// A pendant with a cloth shade and a bulb, `drop` metres from the ceiling to the lower edge of the shade.
Piece pendantLamp(float drop);

/// A lamp with a turned foot and a cloth shade.
Piece tableLamp();

}  // namespace host::furniture
