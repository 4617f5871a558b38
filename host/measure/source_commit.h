#pragma once

namespace host {

/// The commit that this was built from, with "+" behind it where files had been changed; "" where it was not
/// built in a git checkout.
const char* sourceCommit();

}  // namespace host
