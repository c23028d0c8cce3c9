# Puts a page's style and script into it, and the page into a C++ source as a string.
# Called with -DPAGE=... -DSTYLE=... -DSCRIPT=... -DOUTPUT=... -P.
cmake_minimum_required(VERSION 3.25) # leaves @NAME@ alone
file(READ ${PAGE} page)
file(READ ${STYLE} style)
file(READ ${SCRIPT} script)
string(REPLACE "@STYLE@" "${style}" page "${page}")
string(REPLACE "@SCRIPT@" "${script}" page "${page}")
file(WRITE ${OUTPUT} "#include \"report_page.h\"
const std::string_view lichen::kReportPage = R\"lichen_page(${page})lichen_page\";
")
