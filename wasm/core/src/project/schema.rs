//! Changes to generated JSON schemas.

use schemars::Schema;

/// Removes the default from the schema of a key. The real default depends on other keys, so the generated one is wrong.
pub(super) fn without_default(schema: &mut Schema) {
    schema.remove("default");
}
