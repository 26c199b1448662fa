//! Generates TypeScript types from a JSON schema, for the features that this project's schemas use.
//!
//! An object becomes an interface. A choice between objects with a `kind` becomes an interface for each (`PointHandle`,
//! `BarHandle`, …) and their union (`Handle`). The compiler narrows it by `kind`. Descriptions and defaults become doc
//! comments. Everything is read-only, because documents are replaced, not changed.
//!
//! Other schemas are an error.

use std::fmt::Write;

use serde_json::{Map, Value};

/// The first line of every generated file.
pub(crate) const HEADER: &str = "// Generated from the Rust types by `cargo run -p xtask -- schema`. Do not edit.\n";

type Object = Map<String, Value>;

/// An unsupported part of a schema.
#[derive(Debug, thiserror::Error)]
#[error("no TypeScript type is known for the schema {0}")]
pub(crate) struct Unknown(String);

/// Declarations of the schema's own type and of every type it names.
pub(crate) fn declarations(schema: &Value) -> Result<String, Unknown> {
    let mut text = String::from(HEADER);
    let title = schema["title"].as_str().ok_or_else(|| unknown(schema))?;
    declare(&mut text, title, schema)?;
    for (name, definition) in schema["$defs"].as_object().into_iter().flatten() {
        declare(&mut text, name, definition)?;
    }
    Ok(text)
}

/// Appends the declaration of one type.
pub(crate) fn declare(text: &mut String, name: &str, schema: &Value) -> Result<(), Unknown> {
    let object = schema.as_object().ok_or_else(|| unknown(schema))?;
    match (choices(object), object.get("properties")) {
        (Some(choices), _) if choices.iter().all(|choice| kind(choice).is_some()) => {
            let mut names = Vec::new();
            for choice in choices {
                let variant = capitalised(kind(choice).unwrap_or_default()) + name;
                interface(text, &variant, &[object, choice.as_object().ok_or_else(|| unknown(choice))?])?;
                names.push(variant);
            }
            comment(text, "", object);
            write_line(text, &format!("export type {name} = {};", names.join(" | ")));
        }
        (None, Some(_)) => interface(text, name, &[object])?,
        _ => {
            comment(text, "", object);
            write_line(text, &format!("export type {name} = {};", type_of(schema)?));
        }
    }
    Ok(())
}

/// One interface from the properties of several objects, with the description of the last one.
fn interface(text: &mut String, name: &str, parts: &[&Object]) -> Result<(), Unknown> {
    if let Some(part) = parts.last() {
        comment(text, "", part);
    }
    write_line(text, &format!("export interface {name} {{"));
    for part in parts {
        let required = part.get("required").and_then(Value::as_array);
        for (key, schema) in part.get("properties").and_then(Value::as_object).into_iter().flatten() {
            let optional = if required.is_some_and(|keys| keys.iter().any(|k| k == key)) { "" } else { "?" };
            comment(text, "  ", schema.as_object().ok_or_else(|| unknown(schema))?);
            write_line(text, &format!("  readonly {key}{optional}: {};", type_of(schema)?));
        }
    }
    write_line(text, "}");
    Ok(())
}

fn type_of(schema: &Value) -> Result<String, Unknown> {
    let object = schema.as_object().ok_or_else(|| unknown(schema))?;
    if let Some(name) = object.get("$ref").and_then(Value::as_str).and_then(|path| path.strip_prefix("#/$defs/")) {
        return Ok(name.to_owned());
    }
    if let Some(Value::String(text)) = object.get("const") {
        return Ok(format!("'{text}'"));
    }
    if let Some(choices) = choices(object) {
        let types: Result<Vec<_>, _> = choices.iter().map(type_of).collect();
        return Ok(types?.join(" | "));
    }
    if let Some(Value::Array(names)) = object.get("type") {
        let types: Result<Vec<_>, _> =
            names.iter().map(|name| type_of(&Value::from_iter([("type", name.clone())]))).collect();
        return Ok(types?.join(" | "));
    }
    match (object.get("type").and_then(Value::as_str), object.get("prefixItems"), object.get("items")) {
        (Some("number" | "integer"), ..) => Ok("number".to_owned()),
        (Some("boolean"), ..) => Ok("boolean".to_owned()),
        (Some("string"), ..) => Ok("string".to_owned()),
        (Some("null"), ..) => Ok("null".to_owned()),
        (Some("array"), Some(Value::Array(items)), _) => {
            let types: Result<Vec<_>, _> = items.iter().map(type_of).collect();
            Ok(format!("readonly [{}]", types?.join(", ")))
        }
        (Some("array"), None, Some(item)) => {
            let item = type_of(item)?;
            let item = if item.contains(' ') { format!("({item})") } else { item };
            Ok(format!("readonly {item}[]"))
        }
        _ => Err(unknown(schema)),
    }
}

fn choices(object: &Object) -> Option<&Vec<Value>> {
    object.get("oneOf").or_else(|| object.get("anyOf"))?.as_array()
}

/// The value of `kind` that identifies a choice.
fn kind(choice: &Value) -> Option<&str> {
    choice["properties"]["kind"]["const"].as_str()
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn comment(text: &mut String, indent: &str, schema: &Object) {
    let description = schema.get("description").and_then(Value::as_str).map(str::to_owned);
    let default = schema.get("default").filter(|value| !value.is_object()).map(|value| match value.as_f64() {
        Some(number) => format!("Left out: {number}."),
        None => format!("Left out: {value}."),
    });
    let lines: Vec<_> = description.into_iter().chain(default).collect();
    if !lines.is_empty() {
        write_line(text, &format!("{indent}/** {} */", lines.join(" ").replace('\n', " ")));
    }
}

fn write_line(text: &mut String, line: &str) {
    // A blank line precedes each item of the top level. Its comment is part of the item.
    let continues = line.starts_with([' ', '}']) || text.ends_with("*/\n");
    if !continues {
        text.push('\n');
    }
    writeln!(text, "{line}").expect("writing to memory does not fail");
}

fn unknown(schema: &Value) -> Unknown {
    Unknown(schema.to_string())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::declarations;

    #[test]
    fn distinguishes_the_kinds_of_a_choice() {
        let schema = json!({
            "title": "Scene",
            "type": "object",
            "properties": { "shape": { "$ref": "#/$defs/Shape" } },
            "$defs": { "Shape": {
                "properties": { "size": { "type": "number", "description": "In pixels.", "default": 1.0 } },
                "oneOf": [
                    { "properties": { "kind": { "const": "dot" } }, "required": ["kind"] },
                    { "properties": { "kind": { "const": "path" }, "points": {
                        "type": "array", "items": { "enum": [1] }, "prefixItems": [{ "type": "number" }]
                    } }, "required": ["kind", "points"] }
                ]
            } }
        });
        assert_eq!(
            declarations(&schema).unwrap().split_once("\n\n").unwrap().1,
            "export interface Scene {
  readonly shape?: Shape;
}

export interface DotShape {
  /** In pixels. Left out: 1. */
  readonly size?: number;
  readonly kind: 'dot';
}

export interface PathShape {
  /** In pixels. Left out: 1. */
  readonly size?: number;
  readonly kind: 'path';
  readonly points: readonly [number];
}

export type Shape = DotShape | PathShape;
"
        );
    }

    #[test]
    fn optional_numbers_of_results_are_null_if_absent() {
        let schema = json!({
            "title": "Site", "type": "object", "required": ["radius"],
            "properties": { "radius": { "type": ["number", "null"] } }
        });
        assert!(declarations(&schema).unwrap().contains("readonly radius: number | null;"));
    }

    #[test]
    fn rejects_unknown_schemas() {
        let schema = json!({ "title": "Map", "type": "object", "additionalProperties": { "type": "string" } });
        assert!(declarations(&schema).unwrap_err().to_string().contains("additionalProperties"));
    }
}
