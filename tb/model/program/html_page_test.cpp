// SPDX-License-Identifier: Apache-2.0
// HTML pages (sysc/cli/html_page.hpp): data in a page stay data, whatever the name of a file.
#include "sysc/cli/html_page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace curvecore::sysc::html_page_test {

using Json = nlohmann::ordered_json;

const std::string kHead = "<body><script>const D = ";
const std::string kTail = ";</script></body>";

/// The data between head and tail.
std::string filled(const Json& data) {
    const std::string page = html_page(kHead + "/*DATA*/" + kTail, page_json(data));
    EXPECT_EQ(page.substr(0, kHead.size()), kHead);
    EXPECT_EQ(page.substr(page.size() - kTail.size()), kTail);
    return page.substr(kHead.size(), page.size() - kHead.size() - kTail.size());
}

TEST(HtmlPage, NoTextOfTheDataTouchesTheScript) {
    for (const std::string name :
         {"</script><script>alert(1)</script>", "<!--<script>", "a</b></c", "<", "/*DATA*/",
          "\"quoted\" back\\slash", "\xd0\xba\xd1\x80\xd0\xb8\xd0\xb2\xd0\xb0\xd1\x8f"}) {
        const Json data{{"title", name}, {"table", {{name, 1.5}}}};
        const std::string text = filled(data);
        EXPECT_EQ(text.find('<'), std::string::npos) << text;
        EXPECT_EQ(Json::parse(text), data) << text;
    }
}

TEST(HtmlPage, BytesThatAreNoTextAreReplaced) {
    EXPECT_EQ(filled({{"title", "a\xff"}}), R"({"title":"a\ufffd"})");
}

}  // namespace curvecore::sysc::html_page_test
