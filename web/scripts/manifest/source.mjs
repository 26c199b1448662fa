/**
 * Reads classes and interfaces with their doc comments, through the API of the TypeScript compiler.
 *
 * The checker knows the members that a class inherits, and the words of a type such as `ToolName`.
 */
import { join } from 'node:path';
import { SyntaxKind } from 'typescript/unstable/ast';
import { API } from 'typescript/unstable/sync';
import { ROOT } from '../steps.mjs';

/** @typedef {import('typescript/unstable/sync').Symbol} Symbol */
/** @typedef {import('typescript/unstable/ast').Node} Node */
/**
 * @typedef {Node & {
 *   name?: Node,
 *   type?: import('typescript/unstable/ast').TypeNode,
 *   modifiers?: readonly Node[],
 *   parameters?: readonly Declaration[],
 *   questionToken?: Node,
 *   initializer?: Node,
 * }} Declaration What a member or parameter may have.
 */
/** @typedef {{ text: string, words: string[] | null }} TypeText `words`: all of a type that has nothing but words. */
/** @typedef {{ description: string, tags: { name: string, text: string }[] }} Comment */
/** @typedef {{ name: string, type: TypeText, optional: boolean, default: string | null }} Parameter */
/**
 * @typedef {Comment & {
 *   name: string,
 *   owner: string,
 *   file: string,
 *   kind: 'field' | 'accessor' | 'method',
 *   privacy: 'public' | 'protected',
 *   type: TypeText,
 *   written: TypeText | null,
 *   parameters: Parameter[],
 * }} Member `type`: of a method, that of its result. `written`: of a property that can be set.
 */

const PROJECT = join(ROOT, 'web/tsconfig.element.json');
/** `NodeBuilderFlags.NoTruncation`. */
const WHOLE = 1;

/**
 * @template T
 * @param {(source: Source) => T} read
 */
export function withSource(read) {
  const api = new API({ cwd: ROOT });
  try {
    const project = api.updateSnapshot({ openProjects: [PROJECT] }).getProject(PROJECT);
    if (!project) throw new Error(`${PROJECT}: cannot be opened`);
    return read(new Source(project));
  } finally {
    api.close();
  }
}

export class Source {
  #project;

  /** @param {import('typescript/unstable/sync').Project} project */
  constructor(project) {
    this.#project = project;
  }

  /**
   * An exported class or interface.
   * @param {string} file Relative to the root of the repository.
   * @param {string} name
   */
  exported(file, name) {
    const { checker, program } = this.#project;
    const source = program.getSourceFile(join(ROOT, file));
    const module = source && checker.getSymbolAtLocation(source);
    const found = module && checker.getExportsOfModule(module).find((symbol) => symbol.name === name);
    if (!found) throw new Error(`${file} exports no ${name}`);
    return found;
  }

  /**
   * @param {Symbol} symbol
   * @returns {Comment}
   */
  comment(symbol) {
    const { checker } = this.#project;
    return {
      description: flat(checker.getDocumentationCommentOfSymbol(symbol)),
      tags: checker.getJsDocTagsOfSymbol(symbol).map(({ name, text }) => ({ name, text: flat(text ?? '') })),
    };
  }

  /**
   * The members of a class or interface that this project declares, with inherited ones. Private ones and overloads of
   * the platform's methods are left out.
   * @param {Symbol} symbol
   * @returns {Member[]}
   */
  members(symbol) {
    const { checker } = this.#project;
    const type = checker.getDeclaredTypeOfSymbol(symbol);
    return checker.getPropertiesOfType(type).flatMap((member) => {
      const found = member.declarations.map((handle) => handle.resolve(this.#project));
      const declared = /** @type {Declaration[]} */ (found.filter((node) => node !== undefined));
      const [first] = declared;
      if (!first?.getSourceFile().fileName.includes('/web/src/') || member.name.includes('#')) return [];
      const modifiers = declared.flatMap(({ modifiers = [] }) => modifiers.map(textOf));
      const comment = this.comment(member);
      // Overloads that only add types to a method of the platform say nothing.
      if (modifiers.includes('override') && comment.description === '' && comment.tags.length === 0)
        return [];
      const getter = declared.find(({ kind }) => kind === SyntaxKind.GetAccessor);
      const setter = declared.find(({ kind }) => kind === SyntaxKind.SetAccessor);
      const isMethod = first.kind === SyntaxKind.MethodDeclaration;
      const read = getter ?? first;
      const writable = setter
        ? setter.parameters?.[0]
        : getter || modifiers.includes('readonly')
          ? null
          : first;
      return [
        {
          ...comment,
          name: member.name,
          owner: ownerOf(first),
          file: first.getSourceFile().fileName.slice(ROOT.length),
          kind: isMethod ? 'method' : getter || setter ? 'accessor' : 'field',
          privacy: modifiers.includes('protected') ? 'protected' : 'public',
          type: this.#type(read),
          written: isMethod || !writable ? null : this.#type(writable),
          parameters: isMethod ? (first.parameters ?? []).map((one) => this.#parameter(one)) : [],
        },
      ];
    });
  }

  /**
   * A static field of a class, as it is written.
   * @param {Symbol} symbol
   * @param {string} name Of the static member.
   */
  text(symbol, name) {
    const node = symbol.valueDeclaration?.resolve(this.#project);
    const source = node ? textOf(node) : '';
    const [, block = ''] =
      source.match(new RegExp(`static [^=]*\\b${name}\\b[^=]*= ([[{].*?[\\]}]);`, 's')) ?? [];
    return block;
  }

  /** @param {Declaration} node @returns {Parameter} */
  #parameter(node) {
    const isPattern = node.name?.kind === SyntaxKind.ObjectBindingPattern;
    return {
      name: isPattern ? 'options' : node.name ? textOf(node.name) : '',
      type: this.#type(node),
      optional: Boolean(node.questionToken || node.initializer),
      default: node.initializer ? textOf(node.initializer) : null,
    };
  }

  /** @param {Declaration} node @returns {TypeText} */
  #type(node) {
    const { checker } = this.#project;
    const type = node.type ? checker.getTypeFromTypeNode(node.type) : checker.getTypeAtLocation(node);
    if (!type) throw new Error(`no type: ${textOf(node)}`);
    const text = node.type ? textOf(node.type) : checker.typeToString(type, undefined, WHOLE);
    const parts = type.isUnionType() ? (type.getTypes() ?? []) : [type];
    const words = parts.filter((part) => part.isStringLiteralType()).map((part) => String(part.value));
    const others = parts.filter((part) => !part.isStringLiteralType());
    const isAbsent = (/** @type {import('typescript/unstable/sync').Type} */ part) =>
      ['null', 'undefined'].includes(checker.typeToString(part));
    return { text: flat(text), words: words.length > 0 && others.every(isAbsent) ? words : null };
  }
}

/** @param {Node} node */
const textOf = (node) => node.getSourceFile().text.slice(node.getStart(), node.end);

/** The class or interface of a member. @param {Declaration} member */
function ownerOf({ parent }) {
  const { name } = /** @type {Declaration} */ (parent);
  return name ? textOf(name) : '';
}

/** @param {string} text */
const flat = (text) =>
  text
    .split(/\n\s*\n/)
    .map((paragraph) => paragraph.replaceAll(/\s+/g, ' ').trim())
    .join('\n\n');
