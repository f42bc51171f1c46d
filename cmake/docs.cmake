# The documentation as pages: `cmake --build build/release --target docs`, in build/release/docs. A link
# that leads nowhere is an error. Debian: python3-sphinx, python3-myst-parser, furo.
find_program(LIESL_SPHINX sphinx-build PATHS /usr/bin NO_DEFAULT_PATH)
mark_as_advanced(LIESL_SPHINX)
if(LIESL_SPHINX)
  add_custom_target(docs
    COMMAND ${LIESL_SPHINX} -q -n -W --keep-going -c ${PROJECT_SOURCE_DIR}/docs/sphinx
            -d ${PROJECT_BINARY_DIR}/docs/.trees ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/docs
    COMMENT "Pages of the documentation in ${PROJECT_BINARY_DIR}/docs" VERBATIM)
endif()
