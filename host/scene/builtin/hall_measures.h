// The hall's plan and section, in metres. The nave runs along z, seven bays long, between two arcades; +Y is
// up.
#pragma once

#include <array>

namespace host::hall {

constexpr float kBay = 5.0f;
constexpr std::array<float, 7> kBayCentres{-15.0f, -10.0f, -5.0f, 0.0f, 5.0f, 10.0f, 15.0f};
constexpr std::array<float, 8> kColumnLines{-17.5f, -12.5f, -7.5f, -2.5f, 2.5f, 7.5f, 12.5f, 17.5f};
constexpr float kHalfLength = 17.5f;  ///< to the inner faces of the end walls

// Plan
constexpr float kArcade = 6.0f;     ///< |x| of the arcades' middle planes
constexpr float kThickness = 0.9f;  ///< of all walls
constexpr float kHalfWall = 0.5f * kThickness;
constexpr float kNaveFace = kArcade - 0.5f * kThickness;
constexpr float kAisleFace = kArcade + 0.5f * kThickness;
constexpr float kOuterFace = kAisleFace + 4.0f;  ///< inner face of the outer walls
constexpr float kOutside = kOuterFace + kThickness;
constexpr float kArchRadius = 1.95f;  ///< clear, of both storeys' arches

// Section
constexpr float kFoundation = -0.5f;     ///< how deep the walls reach below the floor
constexpr float kSpringing = 4.3f;       ///< of the ground-floor arches and aisle vaults
constexpr float kGallery = 7.2f;         ///< the gallery's floor
constexpr float kUpperSpringing = 9.4f;  ///< of the gallery's arches
constexpr float kVaultSpringing = 9.8f;  ///< of the nave vault
constexpr float kVaultRise = 3.5f;
constexpr float kAisleVaultRise = 2.1f;
constexpr float kGalleryCeiling = 11.9f;
constexpr float kGalleryRoof = 12.4f;
constexpr float kRoof = 13.6f;

// The stairs at the far end (-z)
constexpr int kSteps = 12;
constexpr float kRiser = 0.165f;
constexpr float kTread = 0.34f;
constexpr float kPlatformHeight = kRiser * kSteps;
constexpr float kPlatformFront = -13.5f;  ///< z
constexpr float kPlatformHalfWidth = 4.9f;
constexpr float kStairHalfWidth = 3.2f;

constexpr float kSunk = 0.02f;  ///< how deep things stand in what carries them, so that no faces coincide

}  // namespace host::hall
