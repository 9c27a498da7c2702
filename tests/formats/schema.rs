//! As much of JSON Schema as the schemas in docs/schema use; any other keyword is an error, so that none is silently ignored.

use serde_json::Value;

/// Every violation, with the place in the document.
pub fn violations(schema: &Value, document: &Value) -> Vec<String> {
    let mut found = Vec::new();
    check(schema, schema, document, "$", &mut found);
    found
}

/// A schema of docs/schema.
pub fn load(name: &str) -> Value {
    let path = format!("{}/docs/schema/{name}.schema.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn check(root: &Value, schema: &Value, doc: &Value, at: &str, found: &mut Vec<String>) {
    for (keyword, rule) in schema.as_object().expect("a schema is an object") {
        let ok = match keyword.as_str() {
            "$schema" | "$id" | "$defs" | "title" | "description" | "default" => true,
            "$ref" => {
                let target = root.pointer(rule.as_str().unwrap().trim_start_matches('#')).expect("$ref resolves");
                check(root, target, doc, at, found);
                true
            }
            "type" => types(rule).any(|t| has_type(doc, t)),
            "const" => doc == rule,
            "enum" => rule.as_array().unwrap().contains(doc),
            "minimum" => doc.as_f64().is_none_or(|v| v >= rule.as_f64().unwrap()),
            "exclusiveMinimum" => doc.as_f64().is_none_or(|v| v > rule.as_f64().unwrap()),
            "maximum" => doc.as_f64().is_none_or(|v| v <= rule.as_f64().unwrap()),
            "maxLength" => doc.as_str().is_none_or(|s| s.chars().count() as u64 <= rule.as_u64().unwrap()),
            "minItems" => doc.as_array().is_none_or(|a| a.len() as u64 >= rule.as_u64().unwrap()),
            "maxItems" => doc.as_array().is_none_or(|a| a.len() as u64 <= rule.as_u64().unwrap()),
            "pattern" => doc.as_str().is_none_or(|s| matches(rule.as_str().unwrap(), s)),
            "required" => {
                let keys = rule.as_array().unwrap().iter().map(|k| k.as_str().unwrap());
                doc.as_object().is_none_or(|o| keys.clone().all(|k| o.contains_key(k)))
            }
            "items" | "properties" => {
                children(root, rule, doc, at, found);
                true
            }
            "additionalProperties" => additional(root, schema, rule, doc, at, found),
            _ => panic!("the test does not know the keyword {keyword}"),
        };
        if !ok {
            found.push(format!("{at}: {keyword} {rule} refuses {doc}"));
        }
    }
}

/// The items of an array, each against the rule; or the fields of an object, each against its own.
fn children(root: &Value, rule: &Value, doc: &Value, at: &str, found: &mut Vec<String>) {
    for (i, item) in doc.as_array().into_iter().flatten().enumerate() {
        check(root, rule, item, &format!("{at}[{i}]"), found);
    }
    for (key, value) in doc.as_object().into_iter().flatten() {
        if let Some(rule) = rule.get(key) {
            check(root, rule, value, &format!("{at}.{key}"), found);
        }
    }
}

fn additional(root: &Value, schema: &Value, rule: &Value, doc: &Value, at: &str, found: &mut Vec<String>) -> bool {
    let known = |key: &str| schema.get("properties").is_some_and(|p| p.get(key).is_some());
    let extra: Vec<_> = doc.as_object().into_iter().flatten().filter(|(k, _)| !known(k)).collect();
    if rule == &Value::Bool(false) {
        return extra.is_empty();
    }
    for (key, value) in extra {
        check(root, rule, value, &format!("{at}.{key}"), found);
    }
    true
}

fn types(rule: &Value) -> impl Iterator<Item = &str> {
    rule.as_array().map_or(std::slice::from_ref(rule), Vec::as_slice).iter().filter_map(Value::as_str)
}

fn has_type(doc: &Value, name: &str) -> bool {
    match name {
        "object" => doc.is_object(),
        "array" => doc.is_array(),
        "string" => doc.is_string(),
        "boolean" => doc.is_boolean(),
        "null" => doc.is_null(),
        "number" => doc.is_number(),
        "integer" => doc.as_f64().is_some_and(|v| v.fract() == 0.0),
        _ => panic!("no such type: {name}"),
    }
}

/// The patterns that the schemas use.
fn matches(pattern: &str, text: &str) -> bool {
    match pattern {
        "^[.@]+$" => !text.is_empty() && text.chars().all(|c| c == '.' || c == '@'),
        "^[0-9a-f]{16}$" => text.len() == 16 && text.chars().all(|c| c.is_ascii_digit() || ('a'..='f').contains(&c)),
        _ => panic!("the test does not know the pattern {pattern}"),
    }
}
