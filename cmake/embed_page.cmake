# Puts a page's style and script into it, and the page into a C++ source as a string.
# Called with -DPAGE=... -DSTYLE=... -DSCRIPT=... -DOUTPUT=... -P.
cmake_minimum_required(VERSION 3.25) # leaves @NAME@ alone
file(READ ${PAGE} page)
file(READ ${STYLE} style)
file(READ ${SCRIPT} script)

# The base64 (section 4 of RFC 4648) of a SHA-256 digest, which has 32 bytes: eleven times three
# bytes but for the last, which "=" stands for.
function(base64_of_sha256 hex output)
  set(digits "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
  set(text "")
  foreach(begin RANGE 0 60 6)
    string(SUBSTRING "${hex}00" ${begin} 6 three)
    foreach(shift 18 12 6 0)
      math(EXPR digit "(0x${three} >> ${shift}) & 63")
      string(SUBSTRING ${digits} ${digit} 1 digit)
      string(APPEND text ${digit})
    endforeach()
  endforeach()
  string(SUBSTRING ${text} 0 43 text)
  set(${output} "${text}=" PARENT_SCOPE)
endfunction()

# The page's policy allows the style and the script that have these hashes, and nothing else.
foreach(part style script)
  string(SHA256 hex "${${part}}")
  base64_of_sha256(${hex} ${part}_hash)
endforeach()
string(REPLACE "@STYLE_HASH@" "${style_hash}" page "${page}")
string(REPLACE "@SCRIPT_HASH@" "${script_hash}" page "${page}")
string(REPLACE "@STYLE@" "${style}" page "${page}")
string(REPLACE "@SCRIPT@" "${script}" page "${page}")
file(WRITE ${OUTPUT} "#include \"report_page.h\"
const std::string_view lichen::kReportPage = R\"lichen_page(${page})lichen_page\";
")
