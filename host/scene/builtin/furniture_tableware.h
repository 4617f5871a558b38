// What stands on a laid table. Everything rests on y = 0; handles point along +X.
#pragma once

#include "host/scene/builtin/furniture.h"

namespace host::furniture {

Piece plate(float radius, Finish glaze);
Piece cupAndSaucer();  ///< with tea in it
Piece mug(Finish glaze, int segments);
Piece teapot();
Piece milkJug();
Piece sugarBowl();

/// Handles towards +Z, tips towards -Z.
Piece spoon(float length);
Piece fork(float length);
Piece knife(float length);

Piece foldedNapkin();
Piece fruitBowl();    ///< with fruit heaped in it
Piece breadBasket();  ///< with croissants and rolls on a cloth
Piece loafOnBoard();  ///< a cut loaf on a wooden board
Piece candlestick(float height);

}  // namespace host::furniture
