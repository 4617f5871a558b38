// What must hold of every peer, whatever the effect and the size.
#include <gmock/gmock.h>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "effects/ssao/ssao.h"
#include "tests/gpu/peers_support.h"
#include "tests/support/allocations.h"
#include "tests/support/gl_state.h"
#include "tests/support/hostile_state.h"
#include "tests/support/sentences.h"
#include "tests/support/synthetic_gbuffer.h"
#include "tests/support/test_effect.h"

namespace mres::test {
namespace {

TEST_F(PeersTest, AConstantStaysWhatItIsAtEverySize) {
  std::vector<SyntheticGBuffer> gbuffers;
  for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(2, 3), glm::ivec2(1, 40), glm::ivec2(17, 9),
                                glm::ivec2(64, 64), glm::ivec2(259, 193)})
    gbuffers.emplace_back(size, perspective(size), room());
  gbuffers.emplace_back(glm::ivec2(70, 50), perspective({70, 50}), sphere({0.0, 0.0, -3.0}, 1.0));
  for (const host::PeerKind& kind : host::peerKinds()) {
    for (const auto& [channels, filtered] :
         {std::pair(1, true), std::pair(1, false), std::pair(3, true), std::pair(3, false)}) {
      TestEffect effect({.body = "return vec4(0.375);",
                         .channels = channels,
                         .filtered = filtered,
                         .background = glm::vec4(0.375f)});
      const auto peer = host::makePeer(kind.name, effect.description());
      for (const SyntheticGBuffer& gbuffer : gbuffers) {
        const Frame& frame = gbuffer.frame();
        ASSERT_THAT(picture(*peer, effect, frame), testing::Each(0.375f))
            << kind.name << " at " << frame.size.x << "x" << frame.size.y << ", channels " << channels;
      }
    }
  }
}

TEST_F(PeersTest, NothingUndefinedIsEverRead) {
  Ssao ssao({.samples = 4});
  TestEffect radiance({.body = "return vec4(fract(surface.position), 1.0);", .channels = 3});
  for (const host::PeerKind& kind : host::peerKinds()) {
    for (Effect* effect : std::initializer_list<Effect*>{&ssao, &radiance}) {
      const auto peer = host::makePeer(kind.name, effect->description());
      for (const glm::ivec2 size : {glm::ivec2(259, 193), glm::ivec2(17, 9), glm::ivec2(64, 48)}) {
        const SyntheticGBuffer gbuffer(size, perspective(size), room());
        const Picture clean = picture(*peer, *effect, gbuffer.frame());
        EXPECT_TRUE(isFinite(clean));
        for (const float poison : {kNan, -60000.0f, 60000.0f}) {
          peer->fillTargets(poison);
          EXPECT_EQ(picture(*peer, *effect, gbuffer.frame()), clean)
              << kind.name << " at " << size.x << "x" << size.y << ", poison " << poison;
        }
      }
    }
  }
}

TEST_F(PeersTest, PicturesDoNotDependOnWhatWasRenderedBefore) {
  const glm::ivec2 size(95, 63);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  const SyntheticGBuffer other({130, 40}, perspective({130, 40}), sphere({0.0, 0.0, -2.0}, 1.0));
  Ssao ssao({.samples = 4});
  for (const host::PeerKind& kind : host::peerKinds()) {
    const auto peer = host::makePeer(kind.name, ssao.description());
    const Picture first = picture(*peer, ssao, gbuffer.frame());
    static_cast<void>(picture(*peer, ssao, other.frame()));
    EXPECT_EQ(picture(*peer, ssao, gbuffer.frame()), first) << kind.name;
    EXPECT_EQ(picture(kind.name, ssao, gbuffer.frame()), first) << kind.name;
  }
}

TEST_F(PeersTest, SsaoOfARoomIsLikeTheReference) {
  const glm::ivec2 size(320, 240);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao({.samples = 32});
  const Picture reference = full(ssao, gbuffer.frame());
  for (const host::PeerKind& kind : host::peerKinds())
    EXPECT_LT(rootMeanSquare(picture(kind.name, ssao, gbuffer.frame()), reference), 0.15) << kind.name;
}

TEST_F(PeersTest, TheHostsStateIsLeftAlone) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao({.samples = 4});
  for (const host::PeerKind& kind : host::peerKinds()) {
    const auto peer = host::makePeer(kind.name, ssao.description());
    const Picture expected = picture(*peer, ssao, gbuffer.frame());
    GLuint result = 0;
    {
      const HostileState hostile;
      const GlState before = captureGlState();
      result = peer->render(ssao, gbuffer.frame());
      EXPECT_THAT(differences(before, captureGlState()), testing::IsEmpty()) << kind.name;
    }
    EXPECT_EQ(readPixels(result, size, 1), expected) << kind.name;
  }
}

TEST_F(PeersTest, ASteadyFrameAllocatesNothing) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao({.samples = 1});
  for (const host::PeerKind& kind : host::peerKinds()) {
    const auto peer = host::makePeer(kind.name, ssao.description(), {.measureWork = true});
    for (const auto mode : {gl::Profiler::Mode::off, gl::Profiler::Mode::query, gl::Profiler::Mode::finish}) {
      peer->setProfiling(mode);
      for (int frame = 0; frame < 10; ++frame) peer->render(ssao, gbuffer.frame());
      const AllocationCounter allocations;
      for (int frame = 0; frame < 10; ++frame) peer->render(ssao, gbuffer.frame());
      EXPECT_EQ(allocations.count(), 0u) << kind.name << ", profiling mode " << static_cast<int>(mode);
    }
  }
}

TEST_F(PeersTest, TellTheirStagesAndBytes) {
  const glm::ivec2 size(97, 61);
  const SyntheticGBuffer gbuffer(size, perspective(size), room());
  Ssao ssao({.samples = 1});
  for (const host::PeerKind& kind : host::peerKinds()) {
    const auto peer = host::makePeer(kind.name, ssao.description());
    peer->setProfiling(gl::Profiler::Mode::finish);
    peer->render(ssao, gbuffer.frame());
    EXPECT_THAT(peer->stages(), testing::Contains(testing::Field(&gl::StageTime::name, "mres.filter")))
        << kind.name;
    EXPECT_GT(peer->bytes(), 97u * 61u * 2u) << kind.name;
  }
}

TEST_F(PeersTest, UnknownNamesAndOtherEffectsAreRefused) {
  const SyntheticGBuffer gbuffer({40, 30}, perspective({40, 30}), room());
  TestEffect effect({.body = "return vec4(0.25);"});
  TestEffect other({.body = "return vec4(0.5);"});
  EXPECT_THAT([&] { host::makePeer("third-joint", effect.description()); },
              refusesInASentence<std::invalid_argument>("'third-joint'"));
  for (const host::PeerKind& kind : host::peerKinds()) {
    const auto peer = host::makePeer(kind.name, effect.description());
    EXPECT_THAT([&] { peer->render(other, gbuffer.frame()); }, refusesInASentence<std::logic_error>("'test'"))
        << kind.name;
    EXPECT_THAT(picture(*peer, effect, gbuffer.frame()), testing::Each(0.25f)) << kind.name;
  }
}

}  // namespace
}  // namespace mres::test
