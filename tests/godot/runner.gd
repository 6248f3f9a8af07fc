extends Node
## Runs scripts that the page gives. A script has a function `run(main)`; what that returns goes back
## to the page as JSON.

var window: JavaScriptObject = JavaScriptBridge.get_interface("window")
var asked: JavaScriptObject = JavaScriptBridge.create_callback(_ask)


func _ready() -> void:
	window.askGodot = asked
	window.isReady = true


func _ask(arguments: Array) -> void:
	var script := GDScript.new()
	script.source_code = arguments[0]
	var problem := script.reload()
	if problem != OK:
		window.answer(JSON.stringify({"problem": error_string(problem)}))
		return
	var answer: Variant = await script.new().run(self)
	window.answer(JSON.stringify({"answer": answer}))
