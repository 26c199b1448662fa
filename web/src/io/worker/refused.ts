/** A file that the browser cannot make; the message is for people. */
export class Refused extends Error {}
