// SPDX-License-Identifier: MIT
#include "mcp/resources.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pipeline/components.hpp"

namespace grafverif::mcp {

namespace {

struct Resource {
    std::string uri = {}, name = {}, title = {}, type = {};
    std::string_view text = {};
};

/// Returns the text of the first heading of a page.
std::string title_of(const Page& page) {
    const std::string_view line = page.text.substr(0, page.text.find('\n'));
    return std::string(line.substr(line.find_first_not_of("# ")));
}

std::vector<Resource> resources() {
    std::vector<Resource> all;
    for (const Page& page : pages())
        all.push_back({fmt::format("grafverif://reference/{}", page.name), std::string(page.name), title_of(page),
                       "text/markdown", page.text});
    for (const LibraryEntry& entry : library())
        all.push_back({fmt::format("grafverif://component/{}", entry.name), std::string(entry.name),
                       fmt::format("Component {} of the library", entry.name), "text/plain", entry.text});
    return all;
}

}  // namespace

Json resource_list() {
    Json list = Json::array();
    for (const Resource& each : resources())
        list.push_back({{"uri", each.uri},
                        {"name", each.name},
                        {"title", each.title},
                        {"description", each.title},
                        {"mimeType", each.type},
                        {"size", each.text.size()}});
    return {{"resources", std::move(list)}};
}

std::optional<Json> resource_content(std::string_view uri) {
    for (const Resource& each : resources())
        if (each.uri == uri)
            return Json{{"contents", Json::array({{{"uri", each.uri}, {"mimeType", each.type}, {"text", each.text}}})}};
    return {};
}

}  // namespace grafverif::mcp
