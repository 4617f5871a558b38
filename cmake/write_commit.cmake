# Writes OUTPUT, a C++ file with the commit that SOURCE is at, "+" behind it where files were changed since; only if that
# differs from what it says already. Empty where SOURCE is no checkout, or there is no git.
execute_process(COMMAND git -C ${SOURCE} describe --always --abbrev=12 --exclude=* --dirty=+
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed OR NOT EXISTS ${SOURCE}/.git)
  set(commit "")
endif()
set(text "#include \"host/measure/source_commit.h\"

const char* host::sourceCommit() {
  return \"${commit}\";
}
")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT old STREQUAL text)
  file(WRITE ${OUTPUT} "${text}")
endif()
