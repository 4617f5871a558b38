#pragma once

#include <string>
#include <vector>

namespace host {

/// Columns as wide as their widest cell: the first is aligned to the left, the others to the right.
std::string formatTable(const std::vector<std::vector<std::string>>& rows);

}  // namespace host
